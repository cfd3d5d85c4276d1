"""``kagezou export-ae``: footage and one script that builds the composition in After Effects."""

from argparse import Namespace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.after import add_after, hand_on_export
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.reporting import verdict
from kagezou.cli.standing_in import add_missing, missing_of
from kagezou.cli.terminal import give, give_json, note
from kagezou.errors import UsageProblem
from kagezou.io.files.processors import processors
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.export.after_effects.export import HandedOff

DESCRIPTION = """\
Write one folder for After Effects (CC 2018 or newer, any language): gap-free sequences of every shadow, characters and
background, and NAME.jsx, which builds the composition: frame rate, alpha, layer order, Multiply, opacity with its keys
and eases, markers, and nulls for ground, light and grounding points. In After Effects: File > Scripts > Run Script
File. Doing it again brings folder and composition up to date. Prints the script."""
EXAMPLES = """\
  kagezou export-ae walk.kage -o to_ae
  kagezou export-ae walk.kage -o to_ae --per-drawing --mattes core,distance
  kagezou export-ae walk.kage -o to_ae --footage reference --skip-existing
  kagezou export-ae walk.kage -o to_ae --controls
  kagezou export-ae --panel        where the panel Kagezou.jsx lies
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, nargs="?", metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, metavar="DIR", help="the folder for After Effects")
    parser.add_argument("--name", metavar="NAME", help="what the composition is called (as the project)")
    parser.add_argument("--per-drawing", action="store_true", help="each different shadow once, held by time remapping")
    parser.add_argument(
        "--footage", choices=("copy", "reference"), default="copy", help="copy drawings, or leave them where they lie"
    )
    parser.add_argument("--mattes", metavar="LIST", default="", help="out of shadow,core,distance,lit,receivers")
    parser.add_argument("--controls", action="store_true", help="a null whose sliders drive all shadows")
    parser.add_argument("--format", choices=("png", "exr"), default="png", help="the format of the shadows (png)")
    parser.add_argument("--depth", type=int, choices=(8, 16), default=8, help="bits a channel of png (8)")
    parser.add_argument(
        "--skip-existing", action="store_true", help="leave whole frames alone that would come out the same"
    )
    parser.add_argument("--workers", type=whole_number, metavar="N", help="threads that read and write files")
    add_missing(parser)
    add_after(parser)
    parser.add_argument("--panel", action="store_true", help="print where the panel for After Effects lies")
    parser.add_argument("--json", action="store_true", help="print one object about what was done")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Hand off what is asked for."""
    from kagezou.export.after.hooks import check_command
    from kagezou.export.after.manifest import Handover
    from kagezou.export.after_effects.export import HandOffRequest
    from kagezou.export.exporters.hand_off import HAND_OFF
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load
    from kagezou.locations import resource_folder

    if options.panel:
        give(shown(resource_folder() / "after_effects" / "Kagezou.jsx"))
        return 0
    if options.project is None or options.output is None:
        raise UsageProblem(Message("export-ae needs PROJECT.kage and -o DIR (see kagezou export-ae --help)"))
    check_command(options.after)
    request = HandOffRequest(
        folder=options.output,
        name=options.name or options.project.stem,
        per_drawing=options.per_drawing,
        copies=options.footage == "copy",
        mattes=tuple(each for each in options.mattes.split(",") if each),
        controls=options.controls,
        format=options.format,
        depth=options.depth,
        skip_existing=options.skip_existing,
        workers=options.workers or processors(),
        missing=missing_of(options),
    )
    document = load(options.project)
    with stopping_gently() as interruption:
        with entry_points.line("rendering") as line:
            done = HAND_OFF.export(document, request, entry_points.open_context, line.update, interruption.is_set)
        _report(done, as_json=options.json)
        files, is_whole = HAND_OFF.made_files(done), done.script is not None
        over = partial(Handover, HAND_OFF.key, document, options.project, files, is_whole, done.notes)
        if not hand_on_export(over, options.after, interruption.is_set):
            return interruption.exit_code
    return max(verdict(each, interruption) for each in done.exports)


def _report(done: "HandedOff", *, as_json: bool) -> None:
    """Print the script, or one object; notes go to stderr."""
    from kagezou.io.files.faults import shown

    for sentence in done.notes:
        note(sentence)
    script = "" if done.script is None else shown(done.script)
    if as_json:
        give_json({
            "script": script,
            "files": sum(each.files for each in done.exports),
            "written": sum(each.written for each in done.exports),
            "trusted": sum(each.trusted for each in done.exports),
            "folders": [shown(folder) for each in done.exports for folder in each.folders],
            "notes": [str(each) for each in done.notes],
            "seconds": round(done.seconds, 3),
        })  # fmt: skip
    elif script:
        give(script)
