"""``kagezou render``: shadow layers and composites as numbered frames."""

from argparse import Namespace
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Final

from kagezou.cli.after import add_after, hand_on_export
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import Interruption, stopping_gently
from kagezou.cli.naming import add_naming, names_of
from kagezou.cli.openjd_lines import JobLines
from kagezou.cli.reporting import report, verdict
from kagezou.cli.standing_in import add_missing, missing_of
from kagezou.cli.terminal import ProgressLine, note
from kagezou.errors import UsageProblem
from kagezou.io.files.processors import processors
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document
    from kagezou.export.after.manifest import Handover
    from kagezou.export.exporters.numbered_frames import NumberedFrames
    from kagezou.export.request import Cancelled, ExportRequest, Progress, Summary

_WORTH_SHARING: Final = 12
_LIBRARIES: Final = ("kagezou.io.images.cel_cache", "concurrent.futures.thread", "statistics")
"""What loads libraries that a frame wants: while the driver loads its own no other can be."""

DESCRIPTION = """\
Write each layer's shadow as DIR/NAME_shadow/NAME_shadow_0001.png ...: the shadow's colour everywhere, straight alpha,
one file for every frame. Prints the folders. A picture that is held or comes again is drawn once."""
EXAMPLES = """\
  kagezou render walk.kage -o shadows
  kagezou render walk.kage -o shadows --composite --frames 1-48
  kagezou render walk.kage -o look --composite --guides --frames 1,13,25        where the set stands
  kagezou render walk.kage -o shadows --layer Hero --format exr
  kagezou render walk.kage -o frames --layered --depth 16
  kagezou render walk.kage -o shadows --names '{layer}_{kind}.{frame:04d}' --start-frame 1001
  kagezou render walk.kage -o shadows --skip-existing        goes on after an interruption
  kagezou render walk.kage -o shadows --frames 1-10 --openjd        as a task of a farm
  kagezou render walk.kage -o shadows --composite --watch        makes anew what changes, until Ctrl-C
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="DIR", help="where the folders are made")
    parser.add_argument("--frames", metavar="LIST", help="such as 1-48 or 3,7,10-20 (the whole cut)")
    parser.add_argument("--layer", action="append", metavar="NAME", help="only this layer; may be given several times")
    parser.add_argument("--format", choices=("png", "tga", "tiff", "exr", "psd"), help="the format (png; layered: psd)")
    parser.add_argument("--depth", choices=("auto", "8", "16"), default="auto", help="bits a channel (8; exr has 16)")
    _add_contents(parser)
    add_naming(parser)
    _add_running(parser)
    add_after(parser)


def _add_contents(parser: Parser) -> None:
    """Say what else than shadows can be written."""
    parser.add_argument(
        "--united", action="store_true", help="also DIR/shadows/: the shadows of a look as one (several: NAME_shadows/)"
    )
    parser.add_argument(
        "--composite", action="store_true", help="also DIR/composite/: background, shadows and characters"
    )
    parser.add_argument(
        "--guides",
        action="store_true",
        help="with --composite: ground, walls, boxes and feet as lines over it, for looking, not for compositing",
    )
    parser.add_argument(
        "--receivers", action="store_true", help="also DIR/ground_matte/ and DIR/PIECE_matte/: where each is seen"
    )
    parser.add_argument(
        "--layered",
        action="store_true",
        help="DIR/layered/ instead: each frame one psd or exr of background, shadows and characters",
    )


def _add_running(parser: Parser) -> None:
    """Say how it may be done."""
    parser.add_argument(
        "--skip-existing", action="store_true", help="leave whole frames alone that would come out the same"
    )
    parser.add_argument("--workers", type=whole_number, metavar="N", help="threads that read and write files")
    parser.add_argument(
        "--keep-going", action="store_true", help="make the other frames when a drawing cannot be read; exit code 8"
    )
    add_missing(parser)
    parser.add_argument(
        "--watch",
        action="store_true",
        help="go on until stopped, and make anew what changes on disk: drawings, project, sets, timesheet",
    )
    parser.add_argument(
        "--timesheet", type=Path, metavar="SHEET.xdts", help="expose the drawings as it says; the project stays"
    )
    parser.add_argument(
        "--json", action="store_true", help="print one object about what was done; with --watch one line for each round"
    )
    parser.add_argument(
        "--openjd", action="store_true", help="print progress and failures as Open Job Description reads them"
    )
    parser.add_argument(
        "--path-mapping", type=Path, metavar="FILE", help="rules of Open Job Description: where pictures lie here"
    )


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Render what is asked for."""
    request, said = _request(options)
    if options.watch:
        return _watched(options, request, entry_points)
    lines = JobLines() if options.openjd else entry_points.line("rendering")
    with stopping_gently() as interruption:
        with lines as line:
            if isinstance(lines, JobLines) and said is not None:
                lines.say(said)
            document = _document(options)
            with _loading_driver(document, request):
                summary = _made(document, request, entry_points, line.update, interruption)
            if isinstance(lines, JobLines):
                lines.sum_up(summary)
        if not options.openjd:
            report(summary, as_json=options.json)
        if not hand_on_export(partial(_handover, options, document, summary), options.after, interruption.is_set):
            return interruption.exit_code
    return verdict(summary, interruption)


def _made(
    document: "Document",
    request: "ExportRequest",
    entry_points: EntryPoints,
    progress: "Progress",
    interruption: Interruption,
) -> "Summary":
    """Make the frames, and add what is to be said of the drawings they show."""
    from kagezou.export.frames import export_frames
    from kagezou.importing.file_notes import notes_on_shown
    from kagezou.scene.heavy_sets import heavy_words

    if (words := heavy_words(document)) is not None:
        note(words)
    summary = export_frames(document, request, entry_points.open_context, progress, interruption.is_set)
    # Afterwards, when the files are at hand; nothing was read of what is trusted.
    notes = notes_on_shown(document, request.frames) if summary.drawn else ()
    return replace(summary, notes=(*summary.notes, *notes))


def _loading_driver(document: "Document", request: "ExportRequest") -> AbstractContextManager[None]:
    """Load the driver beside what is still to be imported, but where processes may share the frames.

    Those are forked as long as nothing of it is open.
    """
    from kagezou.render.gpu.context import loading_driver

    frames = document.canvas.length_frames if request.frames is None else len(request.frames)
    if request.workers > 1 and frames >= _WORTH_SHARING and not document.pieces:
        return nullcontext()
    for name in _LIBRARIES:
        import_module(name)
    return loading_driver()


def _watched(options: Namespace, request: "ExportRequest", entry_points: EntryPoints) -> int:
    """Render, and render anew what changes, until it is stopped."""
    from kagezou.cli.watched_render import watched
    from kagezou.export.frames import export_frames

    if options.openjd:
        raise UsageProblem(Message("a task of a farm ends: --watch and --openjd do not go together"))

    def export(document: "Document", anew: frozenset[Path], line: ProgressLine, stops: "Cancelled") -> "Summary":
        asked = replace(request, skip_existing=True, keep_going=True, anew=anew)
        summary = export_frames(document, asked, entry_points.open_context, line.update, stops)
        if summary.written:
            hand_on_export(partial(_handover, options, document, summary), options.after, stops)
        return summary

    files = [options.project, options.timesheet, options.path_mapping]
    read_from = tuple(each.absolute() for each in files if each is not None)
    return watched(lambda: _document(options), read_from, export, entry_points, as_json=options.json)


def _handover(options: Namespace, document: "Document", summary: "Summary") -> "Handover":
    """Return what is told of the frames to whatever runs after."""
    from kagezou.export.after.manifest import Handover

    exporter = _exporter(options)
    files = exporter.made_files(summary)
    return Handover(exporter.key, document, options.project, files, summary.is_whole, summary.notes)


def _exporter(options: Namespace) -> "NumberedFrames":
    """Return the exporter that has made the frames; the other one need not be imported."""
    if options.layered:
        from kagezou.export.exporters.layered_frames import LAYERED_FRAMES

        return LAYERED_FRAMES
    from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS

    return SHADOW_LAYERS


def _document(options: Namespace) -> "Document":
    """Return what is rendered: the project, with its pictures where they lie here, exposed as a sheet says."""
    from kagezou.io.project.file import load

    document = load(options.project)
    if options.path_mapping is not None:
        from kagezou.io.project.path_mapping import read_rules, with_mapped_paths

        document = with_mapped_paths(document, read_rules(options.path_mapping))
    if options.timesheet is not None:
        from kagezou.importing.staging import with_timesheet

        timed = with_timesheet(document, options.timesheet)
        for sentence in timed.notes:
            note(sentence)
        document = timed.document
    return document


def _depth(options: Namespace, form: str) -> tuple[int, Message | None]:
    """Return bits a channel, and what is to be said of them.

    Whoever sends a job may change its format and leave a depth behind that this format does not have.
    """
    from kagezou.export.request import DEPTHS

    if options.depth == "auto":
        return DEPTHS[form][0], None
    depth = int(options.depth)
    if depth in DEPTHS[form] or not options.openjd:
        return depth, None
    return DEPTHS[form][0], Message(
        "{format} has no {asked} bits a channel; it is written with {depth}",
        format=form,
        asked=depth,
        depth=DEPTHS[form][0],
    )


def _request(options: Namespace) -> tuple["ExportRequest", Message | None]:
    """Return what is asked for, and what is to be said of it; UsageProblem where it cannot be done."""
    from kagezou.animation.frames import parse_frames
    from kagezou.export.after.hooks import check_command
    from kagezou.export.request import ExportRequest

    check_command(options.after)
    form = options.format or ("psd" if options.layered else "png")
    depth, said = _depth(options, form)
    request = ExportRequest(
        folder=options.output,
        frames=None if options.frames is None else parse_frames(options.frames),
        layers=None if options.layer is None else tuple(options.layer),
        format=form,
        depth=depth,
        composite=options.composite,
        layered=options.layered,
        receivers=options.receivers,
        united=options.united,
        guides=options.guides,
        skip_existing=options.skip_existing,
        workers=options.workers or processors(),
        keep_going=options.keep_going,
        names=names_of(options),
        missing=missing_of(options),
    )
    return request, said
