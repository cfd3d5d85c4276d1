"""Drawings kept in memory, so that a held or revisited one is decoded once."""

import threading
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Final, Literal, Protocol

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.io.images.reading import Cel, Matte, read_cel, read_matte
from kagezou.message import Message
from kagezou.picture_source import PictureSource, file_of

DEFAULT_LIMIT_BYTES: Final = 512 << 20
_Kind = Literal["cel", "matte", "background"]


@dataclass(frozen=True, slots=True)
class _Key:
    """One state of one picture, as a whole drawing or as its matte alone."""

    kind: _Kind
    source: PictureSource
    stamp: FileStamp

    def of(self, kind: _Kind) -> "_Key":
        """Return the key of the same state of the file as another kind."""
        return _Key(kind, self.source, self.stamp)


class CelSource(Protocol):
    """Where whoever draws gets drawings from; each may raise an InputProblem."""

    def cel(self, source: PictureSource) -> Cel:
        """Return a drawing."""
        ...

    def matte(self, source: PictureSource) -> Matte:
        """Return the matte of a drawing."""
        ...

    def background(self, source: PictureSource) -> Cel:
        """Return a picture that is opaque where it has no alpha of its own."""
        ...


class CelCache:
    """Drawings read from files, bounded by memory, the least lately used going first; any thread may ask.

    A picture is known by its file's path, size and times of change, and its part of the file, so an edited one is read
    again. Two threads that ask for one drawing wait for one decoding. A failure is reported to those who waited for
    it and then forgotten.

    Parameters
    ----------
    limit_bytes
        The memory that kept drawings may take together; a larger one is delivered but not kept.
    """

    def __init__(self, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> None:
        self._limit_bytes = limit_bytes
        self._kept: OrderedDict[_Key, Cel | Matte] = OrderedDict()
        self._states: dict[PictureSource, set[_Key]] = {}
        self._nbytes = 0
        self._running: dict[_Key, Future[Cel | Matte]] = {}
        self._lock = threading.Lock()

    @property
    def nbytes(self) -> int:
        """The memory that kept drawings take now."""
        with self._lock:
            return self._nbytes

    def cel(self, source: PictureSource) -> Cel:
        """Return the drawing that comes from ``source``.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        found = self._get(_key("cel", source), lambda: read_cel(source))
        assert isinstance(found, Cel)
        return found

    def matte(self, source: PictureSource) -> Matte:
        """Return the matte of the drawing from ``source``, from the drawing where that is kept or on its way.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        key = _key("matte", source)
        whole = key.of("cel")
        with self._lock:
            has_cel = whole in self._kept or whole in self._running
        found = self._get(whole, lambda: read_cel(source)) if has_cel else self._get(key, lambda: read_matte(source))
        return found.matte if isinstance(found, Cel) else found

    def background(self, source: PictureSource) -> Cel:
        """Return the picture from ``source`` with its white opaque.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        found = self._get(_key("background", source), lambda: read_cel(source, white_is_clear=False))
        assert isinstance(found, Cel)
        return found

    @property
    def limit_bytes(self) -> int:
        """The memory that kept drawings may take together."""
        return self._limit_bytes

    def limit(self, limit_bytes: int) -> None:
        """Let kept drawings take other memory together; what is too much then goes at once."""
        with self._lock:
            self._limit_bytes = limit_bytes
            while self._nbytes > self._limit_bytes:
                self._drop(next(iter(self._kept)))

    def is_kept(self, source: PictureSource) -> bool:
        """Whether the picture from ``source``, as it is now, is kept whole."""
        try:
            key = _key("cel", source)
        except InputProblem:
            return False
        with self._lock:
            return key in self._kept or key.of("background") in self._kept

    def kept_sources(self) -> frozenset[PictureSource]:
        """Return which drawings are kept now."""
        with self._lock:
            return frozenset(self._states)

    def clear(self) -> None:
        """Forget every drawing."""
        with self._lock:
            self._kept.clear()
            self._states.clear()
            self._nbytes = 0

    def _get(self, key: _Key, read: Callable[[], Cel | Matte]) -> Cel | Matte:
        with self._lock:
            kept = self._kept.get(key)
            if kept is not None:
                self._kept.move_to_end(key)
                return kept
            waiting = self._running.get(key)
            if waiting is None:
                mine: Future[Cel | Matte] = Future()
                self._running[key] = mine
        if waiting is not None:
            return waiting.result()
        return self._read(key, read, mine)

    def _read(self, key: _Key, read: Callable[[], Cel | Matte], mine: Future[Cel | Matte]) -> Cel | Matte:
        """Read on behalf of every thread that waits for ``mine``."""
        try:
            found = read()
        except BaseException as error:
            with self._lock:
                del self._running[key]
            mine.set_exception(error)
            raise
        with self._lock:
            del self._running[key]
            self._keep(key, found)
        mine.set_result(found)
        return found

    def _keep(self, key: _Key, found: Cel | Matte) -> None:
        """Keep ``found``, dropping its older states, its separate matte, and the least lately used."""
        for other in [kept for kept in self._states.get(key.source, ()) if self._is_outdone(kept, key)]:
            self._drop(other)
        if found.nbytes > self._limit_bytes:
            return
        self._kept[key] = found
        self._states.setdefault(key.source, set()).add(key)
        self._nbytes += found.nbytes
        while self._nbytes > self._limit_bytes:
            self._drop(next(iter(self._kept)))

    @staticmethod
    def _is_outdone(kept: _Key, key: _Key) -> bool:
        return kept.of(key.kind) != key or (kept.kind, key.kind) == ("matte", "cel")

    def _drop(self, key: _Key) -> None:
        self._nbytes -= self._kept.pop(key).nbytes
        states = self._states[key.source]
        states.remove(key)
        if not states:
            del self._states[key.source]


def _key(kind: _Kind, source: PictureSource) -> _Key:
    path = file_of(source)
    try:
        state = path.stat()
    except OSError as error:
        raise input_problem(path, error) from error
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, Message("it cannot be a file name")) from error
    return _Key(kind, source, stamp_of(state))
