"""The texts of licences that lie in a bundle's folder ``licenses``: without them it may not be passed on.

Packages bring their own in ``*.dist-info``. Here are those of Kagezou, of Python, and of packages whose wheels bring
none (packaging/licenses), a page and a CycloneDX list of what this very bundle is made of, and, on a Debian system,
those of the system's libraries in it.
"""

import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Callable
from pathlib import Path
from typing import Final

ROOT: Final = Path(__file__).resolve().parents[1]
PARTS_LIST: Final = "kagezou.cdx.json"
_TEXTS: Final = ROOT / "packaging" / "licenses"
_DOCUMENTS: Final = Path("/usr/share/doc")
Say = Callable[[str], None]


def collected(python: Path, home: Path) -> Path:
    """Make the folder anew, for the packages of an environment of this Python.

    Raises
    ------
    SystemExit
        This Python has no text of its licence.
    """
    shutil.rmtree(home, ignore_errors=True)
    shutil.copytree(_TEXTS, home)
    shutil.copyfile(ROOT / "LICENSE", home / "kagezou.txt")
    shutil.copyfile(_of_python(), home / "python.txt")
    made = [str(ROOT / "packaging" / "dev_third_party.py"), "--page", str(home / "THIRD_PARTY.md")]
    subprocess.run([str(python), *made, "--sbom", str(home / PARTS_LIST)], check=True)
    return home


def _of_python() -> Path:
    places = (Path(sysconfig.get_path("stdlib")), Path(sys.base_prefix))
    for place in (folder / "LICENSE.txt" for folder in places):
        if place.is_file():
            return place
    raise SystemExit(f"there is no LICENSE.txt of Python in {' or '.join(map(str, places))}")


def add_texts_of_system(libraries: Path, home: Path, say: Say) -> None:
    """Add the texts of the packages that the system's libraries in a bundle's folder come from; what lacks is said."""
    if not sys.platform.startswith("linux"):
        return
    dpkg = shutil.which("dpkg")
    if dpkg is None:
        say("the texts of the system's libraries are not in the bundle: which package they are of is asked of dpkg")
        return
    places = [f"*/{path.name}" for path in sorted(libraries.glob("*.so*")) if path.is_file()]
    told = subprocess.run([dpkg, "-S", *places], capture_output=True, text=True, check=False).stdout
    for package in sorted({line.partition(":")[0] for line in told.splitlines()}):
        text = _DOCUMENTS / package / "copyright"
        if text.is_file():
            shutil.copyfile(text, home / f"{package}.txt")
        else:
            say(f"the bundle has no text of {package}: there is no {text}")
