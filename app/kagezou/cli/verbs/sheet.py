"""``kagezou sheet``: a contact sheet, each character's shadow step by step from its initial state to torn water."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, named_source
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import give, note
from kagezou.errors import UsageProblem
from kagezou.message import Message

DESCRIPTION = """\
Draw a contact sheet: a row for each character, a column for each step from the initial shadow over light, ground,
declination, simplification and its distance to waves. Prints the steps, from left to right.

With --cut a sheet for each style, with its light: a row for each character, frames over its whole cut from left to
right. Prints for each what is seen of the shadow: islands and holes, how its area changes, how much of it the figure
hides, how far it turns, and how fast its outline moves beside the drawing's."""
EXAMPLES = """\
  kagezou sheet -o sheet.png --character Hero=drawings/hero
  kagezou sheet -o sheet.png --character A=cels/A --character B=cels/B --frame 12
  kagezou sheet --cut -o sheets --character A=cels/A --character B=cels/B
  kagezou sheet --cut -o sheets --style Water --character Hero=drawings/hero
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="FILE", help="the picture; with --cut a folder"
    )
    parser.add_argument(
        "--character",
        type=named_source,
        action="append",
        required=True,
        metavar="NAME=DIR_OR_FILE",
        help="a row; may be given several times",
    )
    parser.add_argument("--frame", type=int, default=1, metavar="N", help="the frame shown (1)")
    parser.add_argument("--cut", action="store_true", help="whole cuts, a sheet for each style")
    parser.add_argument("--style", action="append", metavar="NAME", help="with --cut only this style; several times")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Draw the sheet and write it, or those of whole cuts."""
    if options.cut:
        return _cut_sheets(options, entry_points)
    if options.style:
        raise UsageProblem(Message("--style belongs to --cut"))
    from kagezou.cli.contact_sheet import STEP_NAMES, roomy, sheet_of
    from kagezou.importing.staging import CharacterSource
    from kagezou.io.images.writing import write_rgba

    imported = [roomy([CharacterSource(name, source)]) for name, source in options.character]
    with entry_points.open_context():
        sheet = sheet_of([each.document for each in imported], options.frame)
    write_rgba(options.output, sheet)
    for sentence in (each for one in imported for each in one.notes):
        note(sentence)
    give(", ".join(STEP_NAMES))
    return 0


def _cut_sheets(options: Namespace, entry_points: EntryPoints) -> int:
    """Draw a sheet for each style, and say what is seen."""
    from kagezou.cli.contact_sheet import roomy
    from kagezou.cli.cut_sheet import cut_sheet
    from kagezou.cli.verbs.style import named_style, styles_there
    from kagezou.export.names import safe_names
    from kagezou.importing.feet import document_with_feet
    from kagezou.importing.staging import CharacterSource
    from kagezou.io.images.writing import write_rgba

    styles = [named_style(name) for name in options.style or ()] or [each.style for each in styles_there()]
    cuts = []
    for name, source in options.character:
        cut = roomy([CharacterSource(name, source)])
        found = document_with_feet(cut.document, [layer.id for layer in cut.document.layers])
        for sentence in (*cut.notes, *found.notes):
            note(sentence)
        cuts.append(found.document)
    files = safe_names(style.name.en for style in styles)
    options.output.mkdir(parents=True, exist_ok=True)
    with entry_points.open_context():
        for style in styles:
            sheet = cut_sheet(cuts, style)
            path = options.output / f"{files[style.name.en]}.png"
            write_rgba(path, sheet.picture)
            give(str(path))
            for line in sheet.lines:
                give(line)
    return 0
