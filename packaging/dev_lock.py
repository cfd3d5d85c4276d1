"""The exact Python packages that were tested, with their hashes, for every system and Python at once.

``python3 packaging/dev.py lock`` makes the two files anew, with versions as they are where those still fit; a file that
is deleted before gets the newest of everything. ``dev_venv`` installs nothing but what they name.
"""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

from dev_system import run_quietly

_TOOL = "uv>=0.9,<1"
_OLDEST = "3.11"
_BUILD = "hatchling>=1.27\neditables>=0.5\n"
"""What makes an editable installation of the sources; it is locked like all else."""
_GLIBC = (2, 34)
_MACOS = 14


def lock_file(root: Path, extra: str) -> Path:
    """Return where the packages of an extra are named, of the program alone where it is empty."""
    return root / "packaging" / "requirements" / f"{extra or 'run'}.txt"


def reason_not_to_lock() -> str:
    """Return why this system cannot have the locked packages; empty where it can.

    The newest Qt is built for newer systems than the oldest on which the program runs.
    """
    if sys.platform == "linux":
        found = re.fullmatch(r"(\d+)\.(\d+).*", platform.libc_ver()[1] or "")
        if found and (int(found[1]), int(found[2])) < _GLIBC:
            return f"the system's glibc {found[1]}.{found[2]} is older than the newest Qt needs"
    if sys.platform == "darwin" and int(platform.mac_ver()[0].split(".")[0] or 0) < _MACOS:
        return f"macOS {platform.mac_ver()[0]} is older than the newest Qt needs"
    return ""


def make(root: Path, say: Callable[[str], None]) -> None:
    """Write both files; SetupProblem where the tool cannot be had or finds no versions that fit each other."""
    folder = root / "build" / "lock"
    shutil.rmtree(folder, ignore_errors=True)
    say("Making an environment for uv in build/lock ...")
    run_quietly([sys.executable, "-m", "venv", str(folder)], "Making the environment failed")
    inside = folder / ("Scripts" if sys.platform == "win32" else "bin")
    run_quietly([str(inside / "python"), "-m", "pip", "install", "--quiet", _TOOL], "Installing uv failed")
    build = folder / "build.in"
    build.write_text(_BUILD, encoding="utf-8")
    everything = lock_file(root, "dev")
    everything.parent.mkdir(exist_ok=True)
    say(f"Writing {everything.relative_to(root)} ...")
    compiling = [str(inside / "uv"), "pip", "compile", "pyproject.toml", str(build), "--quiet", "--universal"]
    compiling += ["--generate-hashes", "--python-version", _OLDEST, "--no-annotate"]
    compiling += ["--custom-compile-command", "python3 packaging/dev.py lock"]
    _run([*compiling, "--extra", "dev", "--output-file", str(everything)], root)
    alone = lock_file(root, "")
    say(f"Writing {alone.relative_to(root)} ...")
    _run([*compiling, "--constraint", str(everything), "--output-file", str(alone)], root)
    shutil.rmtree(folder)


def _run(command: list[str], root: Path) -> None:
    if subprocess.call(command, cwd=root, stdout=subprocess.DEVNULL):
        raise SystemExit(f"{' '.join(command[:3])} failed; what it said is above")
