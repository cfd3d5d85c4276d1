"""A batch of cuts at a terminal: who is told what of it, and the report."""

from argparse import Namespace
from collections.abc import Callable, Sequence
from pathlib import Path

from kagezou.batch.batch import Batch, Telling, records_in
from kagezou.batch.crew import Pace, fitting, work_through
from kagezou.batch.cut import Cut
from kagezou.batch.farm import BatchJob, write_batch_job
from kagezou.batch.making import unchanged
from kagezou.batch.orders import Orders
from kagezou.batch.record import CutRecord
from kagezou.cli.cut_reports import concluded, report_of
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.terminal import ProgressLine, give, note, one_line, tell
from kagezou.document.taking import Part
from kagezou.errors import Problem
from kagezou.export.farm_program import USUAL, program_here
from kagezou.export.request import Missing
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.files.processors import processors
from kagezou.io.project.paths import absolute
from kagezou.message import Message
from kagezou.own_process import program_words


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
    return concluded(options, orders.output, batch.records, interruption.exit_code)


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
        return [*program_words(), *place, *asked]

    return words


def asked_of_all(options: Namespace, template: str | None) -> list[str]:
    """Return the words that say what is made of every cut; ``template`` is its project as they name it."""
    words = [f"--export={options.export}"]
    words += [] if options.missing == Missing.FAIL else [f"--missing={options.missing}"]
    words += [] if options.style is None else [f"--style={options.style}"]
    words += [] if template is None else [f"--template={template}"]
    words += [] if options.after is None else [f"--after={options.after}"]
    switches = {f"--{part.value}": getattr(options, part.value) for part in Part}
    switches |= {"--with-light": options.with_light, "--renew": options.renew}
    switches |= {"--skip-existing": options.skip_existing}
    return words + [switch for switch, is_on in switches.items() if is_on]


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
            report_of(self._options, self._output, records, self._earlier)
        except Problem as problem:
            if self._told is None:
                self._line.wipe()
                tell(str(problem))
            self._told = problem
