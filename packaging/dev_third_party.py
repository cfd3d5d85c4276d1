"""What is shipped with the program and under which terms: THIRD_PARTY.md and a CycloneDX list, from the packages there.

``python packaging/dev_third_party.py [--sbom FILE]`` is run in the environment that a bundle is made of. It reads what
each package says of itself; what it does not say stands in `_TERMS`, each from its own licence file.
"""

import argparse
import json
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import Distribution, distributions
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
_OURS: Final = "kagezou"
_TOOLS: Final = frozenset({
    "altgraph", "packaging", "pip", "pyinstaller", "pyinstaller-hooks-contrib", "setuptools", "wheel",
})  # fmt: skip
"""What makes a bundle and is not in it."""
_TERMS: Final = {
    "pyside6-essentials": "LGPL-3.0-only (also GPL-2.0, GPL-3.0 or Qt's commercial terms)",
    "shiboken6": "LGPL-3.0-only (also GPL-2.0, GPL-3.0 or Qt's commercial terms)",
    "av": "BSD-3-Clause; its FFmpeg is built with x264 and x265, under GPL-2.0-or-later",
    "usd-core": "TOST-1.0 (Tomorrow Open Source Technology License)",
    "kornia-rs": "Apache-2.0",
}
"""What packages do not say, or not whole."""
_HEAD: Final = """\
# What is shipped with Kagezou, and under which terms

Made by `packaging/dev_third_party.py` from the packages of a bundle; do not edit. Kagezou itself is under the Apache
License 2.0 (`LICENSE`). The licence texts lie in `_internal` of a bundle, in the folders `licenses` and `*.dist-info`,
and in the folders `*.dist-info` of every installation.

**Python** in a bundle is under the PSF License 2. On Linux there are libraries of the system besides (X11, xkbcommon
and others); their texts lie in `licenses`, too.

**Qt and PySide** are used under the LGPL 3. A bundle holds them as libraries of their own in `_internal/PySide6`: they
may be replaced by other builds of the same version, which is all that the licence asks for. On Linux names that nobody
looks up are left out of them (`strip`); nothing else of them is changed.
Their sources are at <https://download.qt.io/official_releases/QtForPython/>.

**ICU**, which comes with Qt, is under the Unicode License 3. On Linux a bundle holds its data (`libicudata`) for
English and Japanese alone; the library of PySide's package may be put back in its place.

**Mesa** (`mesa` in a bundle for Windows, fetched by `packaging/bundle_mesa.py`) is under the MIT licence and others
alike, listed at <https://docs.mesa3d.org/license.html>; the LLVM within it is under the Apache License 2.0 with LLVM
Exceptions, and the build is that of mesa-dist-win, under the MIT licence. Nothing of it is changed.

**Video** (`--with video`, the extra `video`) brings encoders under the GPL. A bundle with it may be passed on under the
terms of the GPL 2 or later alone, which is why the bundles that are released have none.

**USD** (`--with usd`, the extra `usd`) is under the TOST-1.0, the Apache License 2.0 with a changed section on
trademarks.

| package | version | terms |
|---|---|---|
"""


@dataclass(frozen=True, slots=True, order=True)
class Part:
    """A package that is shipped."""

    name: str
    version: str
    terms: str


def parts() -> tuple[Part, ...]:
    """Return the packages of this environment that are shipped, by name."""
    found = {each.metadata["Name"].lower().replace("_", "-"): each for each in distributions()}
    return tuple(
        sorted(Part(name, each.version, _terms(name, each)) for name, each in found.items() if _is_shipped(name))
    )


def _is_shipped(name: str) -> bool:
    return name != _OURS and name not in _TOOLS


def _terms(name: str, package: Distribution) -> str:
    about = package.metadata
    said = _TERMS.get(name) or _first(package, "License-Expression")
    if said:
        return said
    classified = [
        each.rpartition(" :: ")[2] for each in about.get_all("Classifier", []) if each.startswith("License ::")
    ]
    short = next((line.strip() for line in _first(package, "License").splitlines() if line.strip()), "")
    return ", ".join(classified) or short[:80] or "see its licence file"


def _first(package: Distribution, field: str) -> str:
    return next(iter(package.metadata.get_all(field) or ()), "")


def page(shipped: tuple[Part, ...]) -> str:
    """Return THIRD_PARTY.md."""
    return _HEAD + "".join(f"| {each.name} | {each.version} | {each.terms} |\n" for each in shipped)


def sbom(shipped: tuple[Part, ...], version: str) -> dict[str, object]:
    """Return the list of parts in the form of CycloneDX 1.6."""
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.6",
        "version": 1,
        "metadata": {"component": {"type": "application", "name": _OURS, "version": version}},
        "components": list(_components(shipped)),
    }


def _components(shipped: tuple[Part, ...]) -> Iterator[dict[str, object]]:
    for each in shipped:
        address = f"pkg:pypi/{each.name}@{each.version}"
        is_expression = re.fullmatch(r"[\w.+-]+( (AND|OR|WITH) [\w.+-]+)*", each.terms) is not None
        licence = {"expression": each.terms} if is_expression else {"license": {"name": each.terms}}
        yield {
            "type": "library",
            "bom-ref": address,
            "name": each.name,
            "version": each.version,
            "purl": address,
            "licenses": [licence],
        }


def main() -> int:
    """Write both."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--page", type=Path, default=ROOT / "THIRD_PARTY.md")
    parser.add_argument("--sbom", type=Path)
    options = parser.parse_args()
    shipped = parts()
    options.page.write_text(page(shipped), encoding="utf-8", newline="\n")
    if options.sbom is not None:
        from release_notes import version

        options.sbom.write_text(json.dumps(sbom(shipped, version()), indent=2) + "\n", encoding="utf-8", newline="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
