"""``kagezou auto``: many cuts at once from their folders to projects and output, with a report."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Final

from kagezou.cli.after import add_after
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.openjd_lines import JobLines
from kagezou.cli.standing_in import add_missing, missing_of
from kagezou.cli.terminal import give_json, note, tell
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.io.files.processors import processors
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.batch.orders import Orders
    from kagezou.document.taking import Part

DESCRIPTION = """\
Make a project and output of each cut: DIR is a cut, or a folder of cuts, which are folders, timesheets or files of
layers. A folder of a cut has a folder for each column of its timesheet, or numbered drawings, or a file of layers; what
is called BG is the background. Several cuts are made at a time, each in a process of its own, into OUT/NAME; a cut that
fails leaves the others alone. OUT/report.html shows them all; it can be looked at while they are made."""
EXAMPLES = """\
  kagezou auto ep03/cuts --style "Long evening" -o ep03/shadows
  kagezou auto ep03/cuts --template master.kage -o ep03/shadows --export ae --skip-existing
  kagezou auto c012 c013.psd c014/c014.xdts --style water -o out --export layered
  kagezou auto ep03/cuts --template master.kage --light --look -o out --language ja
  kagezou auto ep03/cuts --style water -o /mnt/ep03/out --farm job
"""
_EXPORTS: Final = ("frames", "ae", "layered", "video")
_STUCK_MINUTES: Final = 10


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("cuts", type=Path, nargs="*", default=[], metavar="DIR", help="a cut, or a folder of cuts")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="OUT", help="where each cut gets a folder")
    parser.add_argument("--style", metavar="NAME", help="the look of every character (kagezou style lists them)")
    parser.add_argument("--with-light", action="store_true", help="the style's own light too")
    parser.add_argument(
        "--template", type=project_path, metavar="P.kage", help="a project whose light, looks, ground and set are taken"
    )
    for part in ("light", "look", "ground", "set"):
        parser.add_argument(f"--{part}", action="store_true", help=f"of the template only its {part}, and others named")
    parser.add_argument("--export", choices=_EXPORTS, default="frames", help="what is made of each cut (frames)")
    parser.add_argument("--skip-existing", action="store_true", help="leave cuts alone that would come out the same")
    parser.add_argument("--renew", action="store_true", help="make projects anew that were changed by hand, too")
    parser.add_argument("--jobs", type=whole_number, metavar="N", help="cuts at a time (as the machine allows)")
    parser.add_argument(
        "--stuck-minutes",
        type=whole_number,
        default=_STUCK_MINUTES,
        metavar="N",
        help="a cut in which nothing moves for so long has failed (10)",
    )
    add_missing(parser)
    parser.add_argument("--language", choices=("en", "ja"), help="of the report (the system's)")
    add_after(parser)
    parser.add_argument("--json", action="store_true", help="print one object about all cuts")
    _add_parts_of_the_work(parser)


def _add_parts_of_the_work(parser: Parser) -> None:
    """Say how the work is divided among processes and machines."""
    parser.add_argument(
        "--farm", type=Path, metavar="BUNDLE", help="write a job of these cuts for a render farm instead"
    )
    parser.add_argument(
        "--program",
        metavar="NAME",
        help="how its workers call Kagezou (kagezou where this machine finds it so, else where it lies here)",
    )
    parser.add_argument(
        "--as", dest="name", metavar="NAME", help="make DIR itself, one cut, as OUT/NAME, and no report"
    )
    parser.add_argument("--report", action="store_true", help="only write the report, of what is there")
    parser.add_argument(
        "--expect", action="append", default=[], metavar="NAME", help="with --report: a cut that should be there"
    )
    parser.add_argument(
        "--workers", type=whole_number, metavar="N", help="threads that read and write files, for each cut"
    )
    parser.add_argument("--openjd", action="store_true", help="print progress as Open Job Description reads it")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Make the cuts, or what else is asked for."""
    if options.report:
        from kagezou.cli.cut_reports import report_alone

        return report_alone(options)
    if not options.cuts:
        raise UsageProblem(Message("which cuts? name folders or files (see kagezou auto --help)"))
    orders = _orders(options)
    if options.name is not None:
        return _one_cut(options, orders, entry_points)
    from kagezou.batch.cuts import found_cuts
    from kagezou.cli.many_cuts import all_cuts, farm_job

    found = found_cuts(options.cuts, orders.output)
    for sentence in found.notes:
        note(sentence)
    if options.farm is not None:
        return farm_job(options, orders, found.cuts)
    return all_cuts(options, orders, found.cuts, entry_points)


def _orders(options: Namespace) -> "Orders":
    """Return what is asked for, after looking at what every cut would fail at."""
    from kagezou.batch.orders import EXPORTS, Orders
    from kagezou.cli.verbs.style import named_style
    from kagezou.export.after.hooks import check_command
    from kagezou.io.project.file import load
    from kagezou.io.project.paths import absolute

    parts = _parts(options)
    check_command(options.after)
    if options.template is not None:
        load(options.template)
    lack = EXPORTS[options.export].lacks()
    if lack is not None:
        raise UsageProblem(lack.says)
    output = absolute(options.output)
    if output.exists() and not output.is_dir():
        raise OutputProblem(Message("{path}: a file is in the way of the output folder", path=output))
    return Orders(
        output=output,
        export=options.export,
        style=None if options.style is None else named_style(options.style),
        with_light=options.with_light,
        template=None if options.template is None else absolute(options.template),
        parts=parts,
        skip_existing=options.skip_existing,
        renew=options.renew,
        workers=options.workers or processors(),
        after=options.after,
        missing=missing_of(options),
    )


def _parts(options: Namespace) -> "frozenset[Part]":
    """Return what alone is taken of the template; nothing stands for all of it."""
    from kagezou.document.taking import Part

    named = frozenset(part for part in Part if getattr(options, part.value))
    if named and options.template is None:
        raise UsageProblem(Message("--light, --look, --ground and --set say what is taken of a --template"))
    if options.style is not None and Part.LOOK in named:
        raise UsageProblem(Message("a look is taken of the style or of the template, not of both: --style or --look"))
    return named


def _one_cut(options: Namespace, orders: "Orders", entry_points: EntryPoints) -> int:
    """Make one cut in this process."""
    from kagezou.batch.cut import Cut
    from kagezou.batch.making import Doing, make_cut
    from kagezou.batch.record import State
    from kagezou.cli.cut_reports import facts_of
    from kagezou.export.names import safe_names
    from kagezou.io.project.paths import absolute

    if len(options.cuts) != 1:
        raise UsageProblem(Message("--as names one cut"))
    cut = Cut(safe_names([options.name])[options.name], absolute(options.cuts[0]))
    lines = JobLines() if options.openjd else entry_points.line(cut.name, unit=None)
    with stopping_gently() as interruption, lines as line:
        made = make_cut(cut, orders, Doing(entry_points.open_context, line.update, interruption.is_set))
        if isinstance(lines, JobLines) and made.record.problem is not None:
            lines.say(Message("failed: {problem}", problem=made.record.problem))
    for sentence in made.record.notes:
        note(sentence)
    if options.json:
        give_json(facts_of(made.record, orders.output))
    if made.record.state is State.STOPPED:
        return interruption.exit_code
    if made.problem is None:
        return 0
    tell(str(made.problem))
    # The other tasks of a farm go on, and the report, which waits for all of them, tells which cuts failed.
    return 0 if options.openjd else made.problem.exit_code
