"""``kagezou export-scene``: pictures of layers, and the scene of another program that lays them on each other."""

from argparse import Namespace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.after import add_after, hand_on_export
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.standing_in import add_missing
from kagezou.cli.terminal import give, give_json, note, tell
from kagezou.io.files.processors import processors

if TYPE_CHECKING:
    from kagezou.export.exchange.export import SceneMade

PROGRAMS = ("blender", "nuke", "natron", "fusion", "opentoonz", "oca")
DESCRIPTION = """\
Write one folder for another program: the pictures of every layer (background, shadows, characters), straight alpha, and
the scene that lays them on each other as Kagezou does: size, frame rate, first frame, order, Multiply, opacity, holds.
The scene finds the pictures beside itself. Prints the scene."""
EXAMPLES = """\
  kagezou export-scene walk.kage --for blender -o to_blender
  kagezou export-scene walk.kage --for nuke -o to_nuke --depth 16
  blender --python to_blender/walk.py
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("--for", dest="program", choices=PROGRAMS, required=True, help="the program")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="DIR", help="the folder for it")
    parser.add_argument("--name", metavar="NAME", help="what the cut is called (as the project)")
    parser.add_argument("--depth", type=int, choices=(8, 16), default=8, help="bits a channel of the pictures (8)")
    parser.add_argument("--work-area", action="store_true", help="only the frames of the work area")
    parser.add_argument("--workers", type=whole_number, metavar="N", help="threads that read and write files")
    add_missing(parser)
    add_after(parser)
    parser.add_argument("--json", action="store_true", help="print one object about what was done")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Write the scene."""
    from dataclasses import replace

    from kagezou.export.after.hooks import check_command
    from kagezou.export.after.manifest import Handover
    from kagezou.export.choices import ExportChoices, Place
    from kagezou.export.exporters.table import SCENES
    from kagezou.io.project.file import load

    check_command(options.after)
    exporter = next(each for each in SCENES if each.program == options.program)
    document = load(options.project)
    place = Place(options.output, options.project, options.name or options.project.stem)
    choices = ExportChoices(
        exporter.key, depth=options.depth, only_work_area=options.work_area, missing=options.missing
    )
    request = replace(exporter.request(document, choices, place), workers=options.workers or processors())
    with stopping_gently() as interruption:
        with entry_points.line("rendering") as line:
            made = exporter.export(document, request, entry_points.open_context, line.update, interruption.is_set)
        _report(made, as_json=options.json)
        if made.scene is None:
            tell("stopped; the scene is written last, when all it needs is there")
            return interruption.exit_code
        files = exporter.made_files(made)
        over = partial(Handover, exporter.key, document, options.project, files, is_whole=True, notes=made.notes)
        if not hand_on_export(over, options.after, interruption.is_set):
            return interruption.exit_code
    return 0


def _report(made: "SceneMade", *, as_json: bool) -> None:
    """Print the scene, or one object; notes go to stderr."""
    from kagezou.io.files.faults import shown

    for sentence in made.notes:
        note(sentence)
    scene = "" if made.scene is None else shown(made.scene)
    if as_json:
        give_json({
            "scene": scene,
            "files": sum(each.files for each in made.counts),
            "written": made.written,
            "notes": [str(each) for each in made.notes],
            "seconds": round(made.seconds, 3),
        })  # fmt: skip
    elif scene:
        give(scene)
