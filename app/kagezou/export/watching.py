"""Making anew what changed on disk: files are looked at now and then, and pictures of those that changed are made.

A file counts as changed when it looks the same twice: whoever is still writing it is waited for. Nothing here waits;
who looks, and how often, is said from outside.
"""

import hashlib
import time
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import Problem
from kagezou.export.request import Summary
from kagezou.io.sets.gltf import files_beside
from kagezou.message import Message

_YOUNG_NS: Final = 3_000_000_000
"""Of two changes within so short a time the second may leave size and times as they are."""

_RETRY_LOOKS: Final = 10
"""What failed is tried again after so many looks, though nothing seems to have changed."""


@dataclass(frozen=True, slots=True)
class _Look:
    """A file at a moment: size, times and number, and what it holds, where these may not tell."""

    facts: tuple[int, ...] | None
    content: str = ""
    is_young: bool = False


class FileWatch:
    """What files were like when they were last looked at.

    Parameters
    ----------
    now_ns
        The time, in nanoseconds since 1970.
    """

    def __init__(self, now_ns: Callable[[], int] = time.time_ns) -> None:
        self._now_ns = now_ns
        self._known: dict[Path, _Look] = {}
        self._coming: dict[Path, _Look] = {}

    def look(self, files: Iterable[Path]) -> tuple[Path, ...]:
        """Return which files changed since they were known, and are the same as at the look before.

        Files that were not among those of the look before are known from now on.
        """
        changed: list[Path] = []
        known: dict[Path, _Look] = {}
        coming: dict[Path, _Look] = {}
        for path in dict.fromkeys(files):
            old = self._known.get(path)
            seen = self._seen(path, old)
            if old is None or seen == replace(old, is_young=seen.is_young):
                known[path] = seen
            elif self._coming.get(path) == seen:
                known[path] = seen
                changed.append(path)
            else:
                known[path], coming[path] = old, seen
        self._known, self._coming = known, coming
        return tuple(changed)

    def know(self, files: Iterable[Path]) -> None:
        """Take files that are not known as they are now."""
        for path in files:
            if path not in self._known:
                self._known[path] = self._seen(path, None)

    def _seen(self, path: Path, old: _Look | None) -> _Look:
        """Return what a file is like; it is read only where its times are young."""
        try:
            found = path.stat()
            facts = (found.st_size, found.st_mtime_ns, found.st_ctime_ns, found.st_ino)
            is_young = abs(self._now_ns() - max(found.st_mtime_ns, found.st_ctime_ns)) < _YOUNG_NS
            if old is not None and old.facts == facts and not old.is_young:
                return old
            if not is_young and (old is None or old.facts != facts):
                return _Look(facts)
            return _Look(facts, hashlib.sha256(path.read_bytes()).hexdigest(), is_young)
        except (OSError, ValueError):
            return _Look(None)


@dataclass(frozen=True, slots=True)
class WatchRound:
    """What one look led to.

    Parameters
    ----------
    changed
        The files that changed.
    summary
        What was made; None where nothing could be.
    problems
        What went wrong and was not told by the round before, one sentence each.
    notes
        What the user should know, each told once.
    """

    changed: tuple[Path, ...]
    summary: Summary | None
    problems: tuple[Message, ...] = ()
    notes: tuple[Message, ...] = ()


@dataclass(frozen=True, slots=True)
class WatchedExport:
    """An export that is made again and again.

    Parameters
    ----------
    read
        Reads the document anew.
    read_from
        The files that it is read from: the project, and perhaps a timesheet.
    export
        Makes what is not there as it should be; pictures of the given files are made even where they seem to be.
    """

    read: Callable[[], Document]
    read_from: tuple[Path, ...]
    export: Callable[[Document, frozenset[Path]], Summary]


class Watch:
    """Keeps an export as its files are.

    Parameters
    ----------
    asked
        The export.
    files
        Tells which files changed.
    """

    def __init__(self, asked: WatchedExport, files: FileWatch) -> None:
        self._asked, self._files = asked, files
        self._document: Document | None = None
        self._failing: frozenset[str] = frozenset()
        self._again: frozenset[Path] = frozenset()
        self._looks_since = 0
        self._told: set[str] = set()

    def first(self) -> WatchRound:
        """Make all that is not there; a Problem that keeps all of it from being made is raised."""
        self._files.know(self._asked.read_from)
        self._document = self._asked.read()
        self._files.know(self._watched())
        return self._made(())

    def look(self) -> WatchRound | None:
        """Look once, and make what changed; None where nothing did and nothing is to be tried again."""
        changed = self._files.look(self._watched())
        self._looks_since += 1
        is_due = bool(self._failing) and self._looks_since >= _RETRY_LOOKS
        if not changed and not is_due:
            return None
        self._looks_since = 0
        try:
            if is_due or any(path in changed for path in self._asked.read_from):
                self._document = self._asked.read()
                # What it shows now is known before it is drawn.
                self._files.know(self._watched())
            made = self._made(changed)
        except Problem as problem:
            made = self._round(changed, None, [problem.message])
        is_news = made.changed or made.problems or (made.summary is not None and made.summary.written)
        return made if is_news else None

    def _made(self, changed: tuple[Path, ...]) -> WatchRound:
        assert self._document is not None
        # Kept until all of it is made: a round may fail, or be stopped.
        self._again |= {*changed, *self._sets_with(changed)}
        summary = self._asked.export(self._document, self._again)
        if summary.is_whole:
            self._again = frozenset()
        return self._round(changed, summary, [each.message for each in summary.failures])

    def _round(self, changed: tuple[Path, ...], summary: Summary | None, failing: Iterable[Message]) -> WatchRound:
        """Return a round with what is new of what fails, and of what there is to say."""
        # By what they say: a message may hold a problem, and no two of these are equal.
        now = {str(each): each for each in failing}
        news = tuple(each for said, each in now.items() if said not in self._failing)
        self._failing = frozenset(now)
        notes = (*self._notes_on_feet(changed), *(summary.notes if summary is not None else ()))
        untold = {str(each): each for each in notes if str(each) not in self._told}
        self._told.update(untold)
        return WatchRound(changed, summary, news, tuple(untold.values()))

    def _watched(self) -> tuple[Path, ...]:
        """Return every file that decides what is made."""
        if self._document is None:
            return self._asked.read_from
        cels = [*(layer.cels for layer in self._document.layers), self._document.behind]
        drawings = [drawing.path for each in cels for drawing in each.drawings]
        sets = self._sets()
        parts = [file for each in sets for file in files_beside(each)]
        return (*self._asked.read_from, *drawings, *sets, *parts)

    def _sets(self) -> tuple[Path, ...]:
        pieces = () if self._document is None else self._document.pieces
        return tuple(piece.source for piece in pieces if piece.source is not None)

    def _sets_with(self, changed: Collection[Path]) -> Iterator[Path]:
        """Yield the sets of which another file than their own changed."""
        return (each for each in self._sets() if any(file in changed for file in files_beside(each)))

    def _notes_on_feet(self, changed: tuple[Path, ...]) -> Iterable[Message]:
        """Yield for each layer with a changed drawing that its feet are those of the project."""
        for layer in () if self._document is None else self._document.layers:
            if any(drawing.path in changed and drawing.feet is not None for drawing in layer.cels.drawings):
                yield Message(
                    "{name}: a drawing changed; its feet are those in the project (kagezou feet finds them anew)",
                    name=layer.name,
                )
