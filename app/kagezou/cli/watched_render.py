"""Rendering until it is stopped: who looks how often at the files, and what is said of each round."""

import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Final

from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import Interruption, stopping_gently
from kagezou.cli.reporting import verdict
from kagezou.cli.terminal import Json, ProgressLine, give, give_json, note, one_line, tell
from kagezou.document.model import Document
from kagezou.export.request import Cancelled, Summary
from kagezou.export.watching import FileWatch, Watch, WatchedExport, WatchRound
from kagezou.io.files.faults import shown
from kagezou.message import Message, first_names

_LOOKING_S: Final = 1.0
_OF_LOOKING: Final = 4
"""Looking at files on a slow network takes at most a part of the time: so many times as long is waited."""

_SLICE_S: Final = 0.1

Export = Callable[[Document, frozenset[Path], ProgressLine, Cancelled], Summary]


def watched(
    read: Callable[[], Document],
    read_from: tuple[Path, ...],
    export: Export,
    entry_points: EntryPoints,
    *,
    as_json: bool,
) -> int:
    """Make what is not there, then what changes, until it is stopped; return the exit code.

    Parameters
    ----------
    read, read_from
        As of `WatchedExport`.
    export
        Makes what is not there; it is told by which line, and when to stop.
    entry_points
        Those of the program.
    as_json
        Whether each round is an object on a line of its own.
    """
    with stopping_gently() as interruption:

        def made(document: Document, anew: frozenset[Path]) -> Summary:
            with entry_points.line("rendering") as line:
                return export(document, anew, line, interruption.is_set)

        watch = Watch(WatchedExport(read, read_from, made), FileWatch())
        first = watch.first()
        _say(first, as_json=as_json, is_first=True)
        if first.summary is not None and first.summary.cancelled:
            return verdict(first.summary, interruption)
        while _wait(interruption, watch, as_json=as_json):
            pass
    tell("stopped watching; every file that is there is whole")
    return interruption.exit_code


def _wait(interruption: Interruption, watch: Watch, *, as_json: bool) -> bool:
    """Look once, and wait; False once it is to stop."""
    began = time.monotonic()
    found = watch.look()
    looked_s = time.monotonic() - began
    if found is not None:
        _say(found, as_json=as_json, is_first=False)
        looked_s = 0.0
    until = time.monotonic() + max(_LOOKING_S, _OF_LOOKING * looked_s)
    while not interruption.is_asked and time.monotonic() < until:
        time.sleep(_SLICE_S)
    return not interruption.is_asked


def _say(made: WatchRound, *, as_json: bool, is_first: bool) -> None:
    """Say what changed, what was made of it, and what went wrong."""
    summary = made.summary
    for sentence in made.notes:
        note(sentence)
    for problem in made.problems:
        tell(str(problem))
    names = [shown(Path(path.name)) for path in made.changed]
    if as_json:
        give_json(_facts(made))
        sys.stdout.flush()
    elif is_first and summary is not None:
        for folder in summary.folders:
            give(one_line(shown(folder)))
        sys.stdout.flush()
        note(Message("{made}; watching", made=_written(summary)))
    elif summary is not None:
        give(one_line(f"{first_names(names) or 'tried again'}: {_written(summary)}"))
        sys.stdout.flush()


def _written(summary: Summary) -> str:
    failed = sum(len(each.frames) for each in summary.failures)
    return f"{summary.written} of {summary.files} files written" + (f", {failed} failed" if failed else "")


def _facts(made: WatchRound) -> Json:
    summary = made.summary
    return {
        "changed": [shown(path) for path in made.changed],
        "files": 0 if summary is None else summary.files,
        "written": 0 if summary is None else summary.written,
        "drawn": 0 if summary is None else summary.drawn,
        "trusted": 0 if summary is None else summary.trusted,
        "failed": [] if summary is None else [list(each.frames) for each in summary.failures],
        "problems": [str(each) for each in made.problems],
        "notes": [str(each) for each in made.notes],
        "folders": [] if summary is None else [shown(folder) for folder in summary.folders],
    }
