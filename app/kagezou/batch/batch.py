"""A batch under way: cuts are made, what came of each is taken down, and the report is written anew."""

import signal
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.batch.crew import Ended
from kagezou.batch.cut import Cut
from kagezou.batch.record import RECORD_NAME, CutRecord, State, read_record, write_record
from kagezou.errors import OutputProblem
from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class Telling:
    """Who is told of a batch.

    Parameters
    ----------
    record
        Told of each cut that is over with.
    progress
        Told how many thousandths of all cuts are done.
    report
        Told of all records whenever one of them changed.
    """

    record: Callable[[CutRecord], None]
    progress: Callable[[int, int], None]
    report: Callable[[Sequence[CutRecord]], None]


class Batch:
    """The cuts of a batch and how they stand; it watches a crew.

    Parameters
    ----------
    cuts
        All of them.
    output
        Where each has its folder.
    telling
        Who is told.
    """

    def __init__(self, cuts: Sequence[Cut], output: Path, telling: Telling) -> None:
        self._cuts, self._output, self._telling = tuple(cuts), output, telling
        self._records = {cut.name: CutRecord(name=cut.name, state=State.WAITING) for cut in cuts}
        self._began: dict[str, tuple[float, int]] = {}
        self._over = 0

    @property
    def records(self) -> tuple[CutRecord, ...]:
        """How the cuts stand, in their order."""
        return tuple(self._records[cut.name] for cut in self._cuts)

    def keep(self, record: CutRecord) -> None:
        """Take in that a cut is left alone."""
        self._records[record.name] = record
        self._over += 1
        self._telling.record(record)

    def began(self, cut: Cut) -> None:
        """Take in that a cut is being made."""
        self._began[cut.name] = (time.monotonic(), _written_at(self._output / cut.name))
        self._records[cut.name] = CutRecord(name=cut.name, state=State.RUNNING)
        # Later ones are told of with the next cut that is over: the report of many cuts is large.
        if not self._over:
            self._telling.report(self.records)

    def ended(self, how: Ended) -> None:
        """Take in how the process of a cut ended; where it left no word, one is left for it."""
        record = self._left_by(how)
        self._records[how.cut.name] = record
        self._over += 1
        self._telling.record(record)
        self._telling.report(self.records)

    def moved(self, parts: float) -> None:
        """Take in how far the cuts are."""
        whole = len(self._cuts) * 1000
        self._telling.progress(min(self._over * 1000 + int(parts * 1000), whole), whole)

    def _left_by(self, how: Ended) -> CutRecord:
        folder = self._output / how.cut.name
        began_s, old = self._began[how.cut.name]
        # What an earlier batch left is no word of this one.
        record = read_record(folder) if _written_at(folder) != old else None
        if record is not None and not how.is_stuck and record.is_whole == (how.code == 0):
            return record
        seconds = time.monotonic() - began_s
        if how.is_stopped:
            return CutRecord(name=how.cut.name, state=State.STOPPED, seconds=seconds)
        record = CutRecord(name=how.cut.name, state=State.FAILED, problem=_why(how), seconds=seconds)
        if folder.is_dir():
            try:
                write_record(record, folder)
            except OutputProblem as problem:
                record = replace(record, notes=(problem.message,))
        return record


def records_in(output: Path, expected: Iterable[str] = ()) -> tuple[CutRecord, ...]:
    """Return the records in an output folder; a cut that was expected and left none is a failed one."""
    try:
        folders = sorted(each for each in output.iterdir() if each.is_dir())
    except OSError:
        folders = []
    found = {folder.name: record for folder in folders if (record := read_record(folder)) is not None}
    lost = Message("nothing is known of it: it was not made here, or the machine that did left no word")
    missing = [CutRecord(name=name, state=State.FAILED, problem=lost) for name in expected if name not in found]
    return (*found.values(), *missing)


def _written_at(folder: Path) -> int:
    """Return when the record in a folder was written, ns; 0 where there is none."""
    try:
        return (folder / RECORD_NAME).stat().st_mtime_ns
    except OSError:
        return 0


def _why(how: Ended) -> Message:
    """Return why the process of a cut left no word of its own."""
    if how.is_stuck:
        return Message("nothing moved in it for too long, so it was ended")
    if how.code < 0:
        return Message("its process was ended by {signal}", signal=_signal_name(-how.code))
    return Message("its process ended with exit code {code}: {said}", code=how.code, said=how.said or "–")


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return str(number)
