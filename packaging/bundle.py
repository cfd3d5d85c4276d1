"""A program that needs no Python: one folder made by PyInstaller for the system this runs on, tried, and packed.

``python3 packaging/bundle.py [--with video usd gradients] [--out DIR]`` makes an environment of its own in
build/bundle, the folder with the licences of all that is in it (bundle_licenses.py), then tries it (bundle_trial.py).
What passes is packed: on Linux as ``.tar.xz``, as a script that unpacks itself, and as ``.deb`` where dpkg-deb is; on
Windows as ``.zip`` (packaging/windows/kagezou.iss makes the installer of the folder); on macOS as ``.dmg``; beside it
lies a CycloneDX list of its parts. Sizes are printed.
"""

import argparse
import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path
from typing import Final

from bundle_licenses import add_texts_of_system, collected
from bundle_mesa import LIBRARIES
from bundle_packing import packed
from bundle_slimming import slimmed
from bundle_trial import say, try_out

ROOT: Final = Path(__file__).resolve().parents[1]
BUILD: Final = ROOT / "build" / "bundle"
PARTS: Final = {"video": "video", "usd": "usd", "gradients": "psd"}
"""What may be taken along, and the extra that brings it."""
_PYINSTALLER: Final = "pyinstaller>=6.11,<7"


def main() -> int:
    """Make, try and pack; return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--with", dest="parts", nargs="*", choices=PARTS, default=[], help="what is taken along besides"
    )
    parser.add_argument("--out", type=Path, default=BUILD / "packed", help="where the packed files go")
    options = parser.parse_args()
    python = _environment(options.parts)
    folder = _made(python, options.parts)
    add_texts_of_system(folder / "_internal", folder / "_internal" / "licenses", say)
    slimmed(folder, say)
    if os.name == "nt":
        with_mesa(folder, ROOT / "build" / "mesa")
    try_out(folder, python, BUILD / "tried", options.parts)
    options.out.mkdir(parents=True, exist_ok=True)
    say(f"{folder}: {_megabytes(folder):.0f} MB")
    for path in packed(folder, options.out, _version()):
        say(f"{path}: {path.stat().st_size / 1e6:.0f} MB")
    return 0


def _environment(parts: list[str]) -> Path:
    """Return the Python of an environment that holds the program, what it needs, and PyInstaller."""
    home = BUILD / "venv"
    python = home / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.is_file():
        venv.create(home, with_pip=True)
    extras = ",".join(sorted({"draco", *(PARTS[part] for part in parts)}))
    wanted = [f"{ROOT}[{extras}]", "aggdraw>=1.4.1,<2", _PYINSTALLER]
    subprocess.run([python, "-m", "pip", "install", "--quiet", *wanted], check=True)
    return python


def _made(python: Path, parts: list[str]) -> Path:
    """Return the folder that PyInstaller makes."""
    words = ["--noconfirm", "--log-level", "WARN", "--distpath", str(BUILD / "dist"), "--workpath", str(BUILD / "work")]
    licenses = collected(python, BUILD / "licenses")
    environment = {
        **os.environ, "KAGEZOU_BUNDLE_WITH": " ".join(parts), "KAGEZOU_BUNDLE_LICENSES": str(licenses),
    }  # fmt: skip
    spec = str(ROOT / "packaging" / "kagezou.spec")
    subprocess.run([python, "-m", "PyInstaller", *words, spec], check=True, env=environment)
    return BUILD / "dist" / "kagezou"


def with_mesa(folder: Path, mesa: Path) -> None:
    """Lay what bundle_mesa.py has fetched into a folder of the bundle, out of which whoever has no driver copies it."""
    if not mesa.is_dir():
        say("the bundle has no OpenGL of its own: packaging/bundle_mesa.py fetches it")
        return
    (folder / "mesa").mkdir()
    for name in LIBRARIES:
        shutil.copyfile(mesa / name, folder / "mesa" / name)


def _megabytes(folder: Path) -> float:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink()) / 1e6


def _version() -> str:
    text = (ROOT / "app" / "kagezou" / "version.py").read_text(encoding="utf-8")
    return text.split('"')[-2]


if __name__ == "__main__":
    sys.exit(main())
