"""``kagezou sheet``: a contact sheet, each character's shadow step by step from its initial state to torn water."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, named_source
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import give, note

DESCRIPTION = """\
Draw a contact sheet: a row for each character, a column for each step from the initial shadow over light, ground,
declination, simplification and its distance to waves. Prints the steps, from left to right."""
EXAMPLES = """\
  kagezou sheet -o sheet.png --character Hero=drawings/hero
  kagezou sheet -o sheet.png --character A=cels/A --character B=cels/B --frame 12
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE", help="the picture to write")
    parser.add_argument(
        "--character",
        type=named_source,
        action="append",
        required=True,
        metavar="NAME=DIR_OR_FILE",
        help="a row; may be given several times",
    )
    parser.add_argument("--frame", type=int, default=1, metavar="N", help="the frame shown (1)")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Draw the sheet and write it."""
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
