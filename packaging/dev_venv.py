"""The private Python environment of a checkout, ``.venv``: made once, mended when something changed.

A stamp inside says for which ``pyproject.toml``, lock, extra, Python and folder the packages were installed, so that a
second run costs one file comparison. A mark, laid down before work begins and taken away when it is done, tells
an interrupted set-up from an environment that somebody made by hand: the first is rebuilt, the second is kept.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from dev_lock import lock_file, reason_not_to_lock
from dev_system import SetupProblem, run_quietly

EXTRAS = ("", "dev")  # each holds all of the one before


@dataclass(frozen=True)
class Environment:
    """The ``.venv`` of one checkout.

    Attributes
    ----------
    root
        The checkout's top folder.
    version
        Major and minor number of the Python that this is to be an environment of.
    """

    root: Path
    version: tuple[int, int]

    @property
    def folder(self) -> Path:
        """The environment's own folder."""
        return self.root / ".venv"

    @property
    def python(self) -> Path:
        """The interpreter inside, on this kind of system."""
        inside = ("Scripts", "python.exe") if os.name == "nt" else ("bin", "python")
        return self.folder.joinpath(*inside)

    @property
    def stamp_file(self) -> Path:
        """The file that says what is installed."""
        return self.folder / "kagezou-ready"

    @property
    def unfinished_mark(self) -> Path:
        """The file that is there only while set-up is at work, or was cut off."""
        return self.folder / "kagezou-unfinished"

    def stamp(self, extra: str) -> str:
        """Return the text that stands for an installation with this extra, from the present project and lock."""
        lock = lock_file(self.root, extra)
        parts = (
            (self.root / "pyproject.toml").read_bytes(),
            lock.read_bytes() if lock.is_file() else b"",
            extra.encode(),
            repr(self.version).encode(),
            os.fsencode(self.root),  # an editable installation points to its checkout by absolute path
        )
        return hashlib.sha256(b"\0".join(parts)).hexdigest()

    def is_ready(self, extra: str) -> bool:
        """Tell, without starting anything, whether this extra or a larger one is installed and current."""
        if self.unfinished_mark.exists() or not self.python.exists():
            return False
        try:
            found = self.stamp_file.read_text(encoding="ascii").strip()
        except (OSError, UnicodeDecodeError):
            return False
        return found in [self.stamp(one) for one in EXTRAS[EXTRAS.index(extra) :]]

    def is_usable(self) -> bool:
        """Tell whether packages can be installed into what is there: whole, of the right Python, with pip."""
        if self.unfinished_mark.exists() or not self.python.exists():
            return False
        question = "import sys, pip; print(*sys.version_info[:2])"
        try:
            asked = subprocess.run(
                [self.python, "-c", question], capture_output=True, text=True, check=False, timeout=60
            )
        except (OSError, subprocess.TimeoutExpired):
            return False
        return asked.stdout.split() == [str(number) for number in self.version]

    def prepare(self, extra: str, say: Callable[[str], None]) -> None:
        """Make the environment hold the project with this extra; does nothing if it already does.

        Raises
        ------
        SetupProblem
            Python or pip could not do it; pip's own last words are printed before.
        """
        if self.is_ready(extra):
            return
        if not self.is_usable():
            self._rebuild(say)
        self.stamp_file.unlink(missing_ok=True)
        self.unfinished_mark.touch()
        say("Installing the Python packages into .venv (the first time, about 190 MB come over the network) ...")
        self._install(extra, say)
        self.stamp_file.write_text(self.stamp(extra) + "\n", encoding="ascii")
        self.unfinished_mark.unlink()

    def compile_sources(self) -> None:
        """Compile what is new of the sources, as pip does for what it installs.

        Python does so itself at the first start, but not where that is switched off or for another user's folder; then
        every start takes a tenth of a second more.
        """
        # What cannot be compiled or written is for the program itself to meet.
        command = [str(self.python), "-m", "compileall", "-qq", str(self.root / "app")]
        subprocess.run(command, capture_output=True, check=False)

    def _install(self, extra: str, say: Callable[[str], None]) -> None:
        """Install the locked packages by their hashes, then the sources; without a lock what fits pyproject.toml."""
        pip = [str(self.python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        problem = "Installing the Python packages failed"
        reason = reason_not_to_lock()
        if reason:
            say(f"Taking the newest packages that fit instead of the tested ones, as {reason}.")
            target = f"{self.root}[{extra}]" if extra else str(self.root)
            run_quietly([*pip, "--editable", target], problem)
            return
        run_quietly([*pip, "--require-hashes", "--requirement", str(lock_file(self.root, extra))], problem)
        # The lock holds what builds it, too: nothing is fetched any more.
        run_quietly([*pip, "--no-deps", "--no-build-isolation", "--editable", str(self.root)], problem)

    def _rebuild(self, say: Callable[[str], None]) -> None:
        if Path(sys.prefix).resolve() == self.folder.resolve():
            raise SetupProblem("The .venv must be rebuilt: please run this with a Python outside it.")
        say(f"Making .venv with Python {self.version[0]}.{self.version[1]} ...")
        try:
            # First of all: what is left if the removal breaks off must not pass for a usable environment.
            self.python.unlink(missing_ok=True)
            if self.folder.is_symlink() or self.folder.is_file():
                self.folder.unlink()
            elif self.folder.exists():
                shutil.rmtree(self.folder)
            self.folder.mkdir()
            self.unfinished_mark.touch()
        except OSError as problem:
            raise SetupProblem(f"The old .venv cannot be replaced; is it in use? ({problem})") from problem
        run_quietly([sys.executable, "-m", "venv", str(self.folder)], "Making the virtual environment failed")
