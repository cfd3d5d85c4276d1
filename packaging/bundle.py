"""A program that needs no Python: one folder made by PyInstaller for the system this runs on, tried, and packed.

``python3 packaging/bundle.py [--with video usd gradients] [--out DIR]`` makes an environment of its own in
build/bundle, the folder, then tries it: the doctor, three frames of the demo and a hand-over byte for byte as the
sources make them, a batch, and the window on a screen of its own. What passes is packed: on Linux as ``.tar.xz``, as a
script that unpacks itself, and as ``.deb`` where dpkg-deb is; on Windows as ``.zip`` (packaging/windows/kagezou.iss
makes the installer of the folder); on macOS as ``.dmg``. Sizes are printed.
"""

import argparse
import os
import shutil
import subprocess
import sys
import time
import venv
from pathlib import Path
from typing import Final

from bundle_mesa import LIBRARIES
from bundle_packing import packed
from bundle_slimming import slimmed
from dev_display import private_display

ROOT: Final = Path(__file__).resolve().parents[1]
BUILD: Final = ROOT / "build" / "bundle"
PARTS: Final = {"video": "video", "usd": "usd", "gradients": "psd"}
"""What may be taken along, and the extra that brings it."""
_FRAMES: Final = "1,7,13"
_PYINSTALLER: Final = "pyinstaller>=6.11,<7"
_TRIED_S: Final = 300
_TERMINATED: Final = 143
_OF_SCREEN: Final = ("DISPLAY", "XDG_RUNTIME_DIR", "QT_QPA_PLATFORM", "LIBGL_ALWAYS_SOFTWARE")


def say(sentence: str) -> None:
    """Print at once: child processes write to the same place."""
    sys.stdout.write(f"{sentence}\n")
    sys.stdout.flush()


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
    slimmed(folder, say)
    if os.name == "nt":
        with_mesa(folder, ROOT / "build" / "mesa")
    try_out(folder, python)
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
    environment = {**os.environ, "KAGEZOU_BUNDLE_WITH": " ".join(parts)}
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


def try_out(folder: Path, python: Path) -> None:
    """Raise SystemExit with one sentence where the bundle does not do what the sources do."""
    program = folder / ("kagezou.exe" if os.name == "nt" else "kagezou")
    work = BUILD / "tried"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    # A bundle finds what it needs in itself: no Python of the machine may help.
    bare = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "VIRTUAL_ENV"))}
    _run([program, "doctor", "--json"], work, bare)
    _run([program, "demo", "made"], work, bare)
    project = next(work.glob("made/*.kage"))
    for words, out in (([program], "bundle"), ([python, "-m", "kagezou"], "sources")):
        _run([*words, "render", project, "-o", work / out, "--composite", "--frames", _FRAMES], work, bare)
        _run([*words, "export-ae", project, "-o", work / f"{out}-ae"], work, bare)
    for made in ("bundle", "bundle-ae"):
        theirs = made.replace("bundle", "sources")
        if _content(work / made) != _content(work / theirs):
            raise SystemExit(f"the bundle makes other files than the sources: {work / made} and {work / theirs}")
    _run([program, "auto", work / "made", "-o", work / "auto", "--style", "Natural"], work, bare)
    _try_window(program, project, work, bare)


def _try_window(program: Path, project: Path, work: Path, environment: dict[str, str]) -> None:
    """Open the window with a project on a screen of its own, wait until it is there, and end it as a desktop does."""
    if not sys.platform.startswith("linux") or shutil.which("xwininfo") is None:
        say("the window was not tried: that takes Linux and xwininfo (x11-utils)")
        return
    with private_display() as screen:
        shown: dict[str, str] = {**environment, **{name: word for name, word in screen.items() if name in _OF_SCREEN}}
        began = time.monotonic()
        with subprocess.Popen([program, project], cwd=work, env=shown, stderr=subprocess.PIPE, text=True) as window:
            while project.stem not in _titles(shown):
                if window.poll() is not None or time.monotonic() - began > _TRIED_S:
                    window.kill()
                    raise SystemExit(f"the bundle shows no window: {window.communicate()[1].strip()}")
                time.sleep(0.05)
            say(f"the window is there after {time.monotonic() - began:.1f} s")
            window.terminate()
            code = window.wait(_TRIED_S)
    if code != _TERMINATED:
        raise SystemExit(f"the bundle's window ended with {code}, not {_TERMINATED}")


def _titles(environment: dict[str, str]) -> str:
    words = ["xwininfo", "-root", "-tree"]
    return subprocess.run(words, env=environment, capture_output=True, text=True, check=False).stdout


def _run(words: list[object], work: Path, environment: dict[str, str]) -> None:
    done = subprocess.run(
        list(map(str, words)), cwd=work, env=environment, capture_output=True, text=True, check=False, timeout=_TRIED_S
    )
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(map(str, words))} ended with {done.returncode}: {done.stderr.strip()}")


def _content(folder: Path) -> dict[str, bytes]:
    """Return what an export made, but for what knows when it was made."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and not path.name.startswith("."))
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files if path.suffix != ".jsx"}


def _megabytes(folder: Path) -> float:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file() and not path.is_symlink()) / 1e6


def _version() -> str:
    text = (ROOT / "app" / "kagezou" / "version.py").read_text(encoding="utf-8")
    return text.split('"')[-2]


if __name__ == "__main__":
    sys.exit(main())
