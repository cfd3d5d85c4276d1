"""A lock beside an open project, so that a second window on it is warned."""

from pathlib import Path

from PySide6.QtCore import QLockFile, QSysInfo

from kagezou.io.project.open_elsewhere import lock_of_window


class ProjectLock:
    """Holds at most one project; the lock of a process that is gone counts for nothing."""

    def __init__(self) -> None:
        self._lock: QLockFile | None = None
        self._path: Path | None = None

    def hold(self, path: Path | None) -> None:
        """Hold this project instead of another; one that others hold, or whose folder is closed, is left alone."""
        if path == self._path:
            return
        self.release()
        self._path = path
        if path is not None:
            lock = _lock_beside(path)
            if lock.tryLock(0):
                self._lock = lock

    def release(self) -> None:
        """Hold nothing."""
        if self._lock is not None:
            self._lock.unlock()
        self._lock, self._path = None, None

    def holder_of(self, path: Path) -> str:
        """Return the name of the computer that has a project open; empty if no other window has."""
        if path == self._path:
            return ""
        lock = _lock_beside(path)
        if lock.tryLock(0):
            lock.unlock()
            return ""
        if lock.error() is not QLockFile.LockError.LockFailedError:
            return ""
        _process, host, _program = lock.getLockInfo()
        return str(host) or QSysInfo.machineHostName()


def _lock_beside(path: Path) -> QLockFile:
    lock = QLockFile(str(lock_of_window(path)))
    lock.setStaleLockTime(0)
    return lock
