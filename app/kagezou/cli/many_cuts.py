"""A batch of cuts at a terminal: who is told what of it, and the report."""

import locale
from argparse import Namespace
from collections.abc import Callable, Iterable, Sequence
from datetime import datetime
from pathlib import Path

from kagezou.batch.batch import Batch, Telling, records_in
from kagezou.batch.crew import Pace, fitting, program, work_through
from kagezou.batch.cuts import Cut
from kagezou.batch.farm import BatchJob, write_batch_job
from kagezou.batch.making import unchanged
from kagezou.batch.orders import Orders
from kagezou.batch.record import CutRecord, State
from kagezou.batch.report import write_report
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.processors import processors
from kagezou.cli.terminal import Json, ProgressLine, give, give_json, note, one_line, tell
from kagezou.document.taking import Part
from kagezou.errors import Problem, SomeFramesFailed
from kagezou.export.farm_program import USUAL, program_here
from kagezou.io.clips.catalogues import messages_in
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.project.paths import absolute
from kagezou.message import Message


def all_cuts(options: Namespace, orders: Orders, cuts: Sequence[Cut], entry_points: EntryPoints) -> int:
    """Make cuts, several at a time, and the report; return the exit code, SomeFramesFailed where some failed."""
    try:
        orders.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(orders.output, error) from error
    at_once = options.jobs or fitting(len(cuts), processors())
    words = words_of_one(options, orders, options.workers or max(processors() // at_once, 1))
    with stopping_gently() as interruption, entry_points.line("making cuts", unit=None) as line:
        speaker = _Speaker(options, orders.output, line)
        batch = Batch(cuts, orders.output, Telling(speaker.say, line.update, speaker.report))
        there = {cut.name: record for cut in cuts if (record := unchanged(cut, orders)) is not None}
        for record in there.values():
            batch.keep(record)
        left = [cut for cut in cuts if cut.name not in there]
        work_through(left, words, Pace(at_once, 60.0 * options.stuck_minutes), batch, interruption.is_set)
    return _concluded(options, orders.output, batch.records, interruption.exit_code)


def report_alone(options: Namespace) -> int:
    """Write the report of the cuts that are in the output folder; as `all_cuts`."""
    output = absolute(options.output)
    return _concluded(options, output, records_in(output, options.expect), 0)


def farm_job(options: Namespace, orders: Orders, cuts: Sequence[Cut]) -> int:
    """Write a job of the cuts for a render farm, and print its template."""
    program = options.program or program_here()
    if options.program is None and program != USUAL:
        note(Message("the workers call {program}; --program names another", program=program))
    language = [] if options.language is None else [f"--language={options.language}"]
    job = BatchJob(
        tuple(cuts),
        orders.output,
        orders.template,
        tuple(asked_of_all(options, None)),
        tuple(language),
        program,
    )
    template, *_ = write_batch_job(job, absolute(options.farm))
    give(shown(template))
    return 0


def words_of_one(options: Namespace, orders: Orders, workers: int) -> Callable[[Cut], list[str]]:
    """Return from a cut to the words of the command that makes it in a process of its own."""
    asked = asked_of_all(options, None if orders.template is None else str(orders.template))

    def words(cut: Cut) -> list[str]:
        place = ["auto", str(cut.path), f"--as={cut.name}", f"--output={orders.output}", f"--workers={workers}"]
        return [*program(), *place, *asked]

    return words


def asked_of_all(options: Namespace, template: str | None) -> list[str]:
    """Return the words that say what is made of every cut; ``template`` is its project as they name it."""
    words = [f"--export={options.export}"]
    words += [] if options.style is None else [f"--style={options.style}"]
    words += [] if template is None else [f"--template={template}"]
    words += [] if options.after is None else [f"--after={options.after}"]
    switches = {f"--{part.value}": getattr(options, part.value) for part in Part}
    switches |= {"--with-light": options.with_light, "--renew": options.renew}
    switches |= {"--skip-existing": options.skip_existing}
    return words + [switch for switch, is_on in switches.items() if is_on]


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


class _Speaker:
    """Says at a terminal what becomes of the cuts, and writes the report meanwhile.

    Parameters
    ----------
    options, output
        What was typed, and where the cuts are made.
    line
        The line of progress, which gives way to what is said.
    """

    def __init__(self, options: Namespace, output: Path, line: ProgressLine) -> None:
        self._options, self._output, self._line = options, output, line
        self._told: Problem | None = None
        self._earlier = records_in(output)

    def say(self, record: CutRecord) -> None:
        """Say what came of a cut."""
        self._line.wipe()
        for sentence in record.notes:
            note(Message("{name}: {note}", name=record.name, note=sentence))
        if record.problem is not None:
            tell(f"{record.name}: {record.problem}")
        elif record.is_whole and not self._options.json:
            give(one_line(shown(self._output / record.name / record.project)))

    def report(self, records: Sequence[CutRecord]) -> None:
        """Write the report; where that is refused it is said once, and the cuts go on."""
        try:
            _write(self._options, self._output, records, self._earlier)
        except Problem as problem:
            if self._told is None:
                self._line.wipe()
                tell(str(problem))
            self._told = problem


def _write(options: Namespace, output: Path, records: Sequence[CutRecord], there: Iterable[CutRecord]) -> Path:
    """Write the report of records, and of what earlier batches left in the same folder."""
    names = {each.name for each in records}
    earlier = (each for each in there if each.name not in names)
    return write_report((*records, *earlier), output, options.language or _language(), datetime.now().astimezone())


def _concluded(options: Namespace, output: Path, records: Sequence[CutRecord], stopped_by: int) -> int:
    """Write the report, say how it went, and return the exit code."""
    records = [
        CutRecord(name=each.name, state=State.STOPPED) if each.state is State.WAITING else each for each in records
    ]
    report = _write(options, output, records, records_in(output))
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
