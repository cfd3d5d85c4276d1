"""``kagezou farm``: a job bundle for a render farm."""

from argparse import Namespace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.after import add_after, hand_on_export
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.naming import add_naming, names_of
from kagezou.cli.standing_in import add_missing, missing_of
from kagezou.cli.terminal import give, note
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.export.request import ExportRequest

DESCRIPTION = """\
Write an Open Job Description job bundle into a folder of its own: template.json, parameter_values.json,
asset_references.json. Run it anywhere with `openjd run`, or give it to Deadline Cloud as it is. Its tasks are chunks of
frames; frames, output, format and the program's name are parameters of the job. Prints the template."""
EXAMPLES = """\
  kagezou farm walk.kage -o shadows --bundle job
  kagezou farm walk.kage -o /mnt/shows/c012/shadows --bundle job --chunk 24 --format exr --composite
  kagezou farm walk.kage --bundle job --layered --format psd
  openjd run job/template.json --step Render -p ProjectFile=$PWD/walk.kage -p OutputDir=$PWD/shadows
  deadline bundle submit job
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument(
        "-o", "--output", type=Path, metavar="DIR", help="where the job renders to (PROJECT_shadows beside the project)"
    )
    parser.add_argument(
        "--bundle", type=Path, metavar="DIR", help="where the bundle is written (PROJECT_job beside the project)"
    )
    parser.add_argument("--chunk", type=whole_number, default=10, metavar="N", help="frames a task (10)")
    parser.add_argument("--frames", metavar="LIST", help="such as 1-48 or 3,7,10-20 (the whole cut)")
    parser.add_argument("--layer", action="append", metavar="NAME", help="only this layer; may be given several times")
    parser.add_argument("--format", choices=("png", "tga", "tiff", "exr", "psd"), help="the format (png; layered: psd)")
    parser.add_argument("--depth", type=int, choices=(8, 16), help="bits a channel (8; exr has 16, tga 8)")
    parser.add_argument("--united", action="store_true", help="also the shadows of each look as one")
    parser.add_argument("--composite", action="store_true", help="also background, shadows and characters in one")
    parser.add_argument("--receivers", action="store_true", help="also mattes of the ground and every set piece")
    parser.add_argument("--layered", action="store_true", help="each frame one psd or exr with all layers instead")
    add_naming(parser)
    add_missing(parser)
    parser.add_argument(
        "--frame-minutes",
        type=whole_number,
        default=10,
        metavar="N",
        help="how long a frame may take before a task is taken for stuck (10)",
    )
    add_after(parser)
    parser.add_argument(
        "--program",
        metavar="NAME",
        help="how the workers call Kagezou (kagezou where this machine finds it so, else where it lies here)",
    )


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Write the bundle."""
    from kagezou.export.after.hooks import check_command
    from kagezou.export.after.manifest import Handover
    from kagezou.export.exporters.farm_job import FARM_JOB, BundleRequest
    from kagezou.export.farm import TEMPLATE, FarmRequest
    from kagezou.export.farm_program import USUAL, program_here
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load

    check_command(options.after)
    project: Path = options.project.absolute()
    output = options.output or project.with_name(f"{project.stem}_shadows")
    bundle: Path = options.bundle or project.with_name(f"{project.stem}_job")
    program = options.program or program_here()
    if options.program is None and program != USUAL:
        note(Message("the workers call {program}; --program says otherwise", program=program))
    document = load(project)
    job = FarmRequest(project, _export(options, output.absolute()), options.chunk, program, options.frame_minutes)
    request = BundleRequest(job, bundle)
    made = FARM_JOB.export(document, request, entry_points.open_context, lambda _done, _all: None, lambda: False)
    give(shown(bundle / TEMPLATE))
    over = partial(Handover, FARM_JOB.key, document, project, FARM_JOB.made_files(made), is_whole=True)
    with stopping_gently() as interruption:
        is_over = hand_on_export(over, options.after, interruption.is_set)
    return 0 if is_over else interruption.exit_code


def _export(options: Namespace, output: Path) -> "ExportRequest":
    """Return what the job makes."""
    from kagezou.animation.frames import parse_frames
    from kagezou.export.request import DEPTHS, ExportRequest

    form = options.format or ("psd" if options.layered else "png")
    return ExportRequest(
        folder=output,
        frames=None if options.frames is None else parse_frames(options.frames),
        layers=None if options.layer is None else tuple(options.layer),
        format=form,
        depth=options.depth or DEPTHS[form][0],
        composite=options.composite,
        receivers=options.receivers,
        united=options.united,
        layered=options.layered,
        names=names_of(options),
        missing=missing_of(options),
    )
