"""Where this program's unsaved work lies: in the first of several folders that takes it, under a lock of its own."""

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from uuid import uuid4

from PySide6.QtCore import QLockFile

from kagezou.errors import OutputProblem
from kagezou.io.project import recovery_file
from kagezou.io.project.recovery_file import SUFFIX, RecoveredWork


@dataclass(frozen=True, slots=True)
class Kept:
    """Work that was put aside.

    Parameters
    ----------
    file
        Where.
    refused
        Why not in the folder that is meant for it; None if it lies there.
    """

    file: Path
    refused: OutputProblem | None


class Keepsakes:
    """One keepsake of one program. All but ``file`` and ``adopt`` may be called on any one thread at a time.

    Parameters
    ----------
    folders
        Where keepsakes may lie, the one that is meant for them first.
    """

    def __init__(self, folders: tuple[Path, ...]) -> None:
        self._files = tuple(folder / f"{uuid4().hex}{SUFFIX}" for folder in folders)
        self._copies: set[Path] = set()
        self._locks: dict[Path, QLockFile] = {}
        self.file = self._files[0]
        """Where unsaved work was kept last, or will be."""

    def adopt(self, file: Path) -> None:
        """Take over what a program that is gone put aside: it stays until this work is kept anew or not wanted."""
        self._copies.add(file)
        self._hold(file)

    def keep(self, work: RecoveredWork) -> Kept:
        """Put work aside; whatever lay elsewhere goes after it was read back.

        Raises
        ------
        ProjectProblem
            The document cannot be kept in a project that loads again.
        OutputProblem
            No folder takes it; what was put aside before is still there.
        """
        refused: list[OutputProblem] = []
        for file in self._files:
            try:
                recovery_file.make_folder(file.parent)
                # First the lock: without it another program would take the work for lost.
                self._hold(file)
                recovery_file.keep(file, work)
            except OutputProblem as problem:
                refused.append(problem)
                continue
            self.file = file
            self._copies.add(file)
            # What cannot be removed stays; it is offered when the program starts again, which loses nothing.
            with suppress(OutputProblem):
                self._remove(self._copies - {file})
            return Kept(file, refused[0] if refused else None)
        raise refused[0]

    def forget(self) -> None:
        """Remove what was put aside.

        Raises
        ------
        OutputProblem
            The system refuses.
        """
        self._remove(set(self._copies))

    def release(self) -> None:
        """Let others see what still lies there."""
        for lock in self._locks.values():
            lock.unlock()
        self._locks.clear()

    def _remove(self, files: Iterable[Path]) -> None:
        refused: list[OutputProblem] = []
        for file in files:
            try:
                recovery_file.forget(file)
            except OutputProblem as problem:
                refused.append(problem)
                continue
            self._copies.discard(file)
            if file not in self._files and (lock := self._locks.pop(file, None)):
                lock.unlock()
        if refused:
            raise refused[0]

    def _hold(self, file: Path) -> None:
        if file not in self._locks:
            lock = _lock(file)
            if lock.tryLock(0):
                self._locks[file] = lock


def lock_of(file: Path) -> Path:
    """Return the lock that the program which keeps this work holds."""
    return file.with_suffix(".lock")


def left_behind(*folders: Path) -> tuple[Path, ...]:
    """Return the keepsakes of programs that are gone without saying goodbye, the latest of each folder first."""
    return tuple(file for folder in folders for file in recovery_file.recovery_files_in(folder) if is_abandoned(file))


def is_abandoned(file: Path) -> bool:
    """Return whether no living program holds a keepsake."""
    lock = _lock(file)
    # Qt itself finds out whether the process that held the lock still lives.
    if lock.tryLock(0):
        lock.unlock()
        return True
    # Where no lock can be made, as in a folder that became read-only, nobody can hold one either.
    return lock.error() is not QLockFile.LockError.LockFailedError


def _lock(file: Path) -> QLockFile:
    lock = QLockFile(str(lock_of(file)))
    lock.setStaleLockTime(0)
    return lock
