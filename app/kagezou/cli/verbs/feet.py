"""``kagezou feet``: find the feet of characters, and say how they stand."""

from argparse import Namespace
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import Json, give, give_json, note, one_line

if TYPE_CHECKING:
    from kagezou.document.model import Document, Layer

DESCRIPTION = """\
Find the feet in the drawings of characters and list how they stand: which foot carries, and how high a jump is.
What a person said about a foot stays."""
EXAMPLES = """\
  kagezou feet walk.kage
  kagezou feet walk.kage --layer Hero
  kagezou feet walk.kage --list --json        finds nothing anew, only lists
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to change")
    parser.add_argument("--layer", action="append", metavar="NAME", help="only this layer; may be given several times")
    parser.add_argument("--list", action="store_true", help="list how the characters stand, and change nothing")
    parser.add_argument("--json", action="store_true", help="print one object")


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Look through the drawings, write what was found, and list it."""
    from kagezou.importing.feet import document_with_feet
    from kagezou.io.project.file import load, save

    before = document = load(options.project)
    layers = _layers(document, options.layer)
    if not options.list:
        with entry_points.line("looking for feet") as line:
            found = document_with_feet(
                document, [layer.id for layer in layers], lambda _part, done, whole: line.update(done, whole)
            )
        document = found.document
        if document != before:
            save(document, options.project)
        for sentence in found.notes:
            note(sentence)
    figures = [layer for layer in layers if layer.joins is None]
    if options.json:
        give_json({layer.name: _about(document, layer) for layer in figures}, indent=2)
        return 0
    for layer in figures:
        for text in _lines(document, layer):
            give(one_line(text))
    return 0


def _layers(document: "Document", names: list[str] | None) -> "list[Layer]":
    if names is None:
        return list(document.layers)
    from kagezou.document.layer_named import layer_named

    return [layer_named(document, name) for name in names]


def _about(document: "Document", layer: "Layer") -> Json:
    """Return the stances of a figure, one for each run of frames."""
    from kagezou.scene.stances import stances_of

    found = stances_of(document, layer.id)
    if found is None:
        return []
    return [
        {
            "frame": frame,
            "lift_px": round(stance.lift_px, 2),
            "doubt": stance.doubt,
            "feet": [
                {
                    "track": foot.track,
                    "place": [round(foot.place[0], 2), round(foot.place[1], 2)],
                    "ground_row": round(foot.ground_row, 2),
                    "planted": foot.is_planted,
                }
                for foot in stance.feet
            ],
        }
        for frame, stance in zip(found.frames, found.stances, strict=True)
    ]


def _lines(document: "Document", layer: "Layer") -> list[str]:
    from kagezou.scene.stances import stances_of

    found = stances_of(document, layer.id)
    if found is None:
        return [f"{layer.name}: no feet"]
    lines = []
    for frame, stance in zip(found.frames, found.stances, strict=True):
        planted = [f"({foot.place[0]:.0f}, {foot.place[1]:.0f})" for foot in stance.feet if foot.is_planted]
        in_air = f"in the air, {stance.lift_px:.0f} px high" if stance.lift_px > 0 else "no foot carries"
        state = " ".join(planted) if planted else in_air if stance.feet else "-"
        lines.append(f"{layer.name} {frame}: {state}{'  ?' if stance.doubt else ''}")
    return lines
