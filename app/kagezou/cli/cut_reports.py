"""What came of many cuts: the page, the exit code, and what a program is told."""

import locale
from argparse import Namespace
from collections.abc import Iterable, Sequence
from datetime import datetime
from pathlib import Path

from kagezou.batch.batch import records_in
from kagezou.batch.record import CutRecord, State
from kagezou.batch.report import write_report
from kagezou.cli.terminal import Json, give, give_json, one_line, tell
from kagezou.errors import SomeFramesFailed
from kagezou.io.clips.catalogues import messages_in
from kagezou.io.files.faults import shown
from kagezou.io.project.paths import absolute
from kagezou.message import Message


def report_alone(options: Namespace) -> int:
    """Write the report of the cuts that are in the output folder; as `all_cuts`."""
    output = absolute(options.output)
    return concluded(options, output, records_in(output, options.expect), 0)


def report_of(options: Namespace, output: Path, records: Sequence[CutRecord], there: Iterable[CutRecord]) -> Path:
    """Write the report of records, and of what earlier batches left in the same folder, and return its file."""
    names = {each.name for each in records}
    earlier = (each for each in there if each.name not in names)
    return write_report((*records, *earlier), output, options.language or _language(), datetime.now().astimezone())


def concluded(options: Namespace, output: Path, records: Sequence[CutRecord], stopped_by: int) -> int:
    """Write the report, say how it went, and return the exit code."""
    records = [
        CutRecord(name=each.name, state=State.STOPPED) if each.state is State.WAITING else each for each in records
    ]
    report = report_of(options, output, records, records_in(output))
    failed = sum(each.state is State.FAILED for each in records)
    code = stopped_by or (SomeFramesFailed.exit_code if failed else 0)
    if options.json:
        cuts = [facts_of(each, output) for each in records]
        give_json({"code": code, "report": shown(report), "cuts": cuts})
    else:
        give(one_line(shown(report)))
    if stopped_by:
        done = sum(each.is_whole for each in records)
        tell(f"stopped with {done} of {len(records)} cuts made; --skip-existing goes on from there")
    elif failed:
        raise SomeFramesFailed(Message("{failed} of {cuts} cuts failed", failed=failed, cuts=len(records)))
    return code


def _language() -> str:
    """Return the language of the system, English where there is no catalogue of it."""
    named = (locale.getlocale()[0] or "").casefold()
    code = named.partition("_")[0][:2]
    try:
        messages_in(code)
    except OSError:
        return "en"
    return code


def facts_of(record: CutRecord, output: Path) -> Json:
    """Return what a program is told of a cut."""
    folder = output / record.name
    return {
        "name": record.name,
        "state": record.state.value,
        "problem": None if record.problem is None else str(record.problem),
        "project": shown(folder / record.project) if record.project else None,
        "output": shown(folder / record.where) if record.counts else None,
        "files": [{"kind": str(kind), "there": there, "files": whole} for kind, there, whole in record.counts],
        "frames": record.frames,
        "layers": list(record.layers),
        "doubtful": {name: list(frames) for name, frames in record.doubtful},
        "notes": [str(each) for each in record.notes],
        "seconds": round(record.seconds, 3),
    }
