"""``kagezou notes``: what people said about a cut, as a list."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give, give_json

if TYPE_CHECKING:
    from kagezou.export.note_list import NoteRow

DESCRIPTION = """\
Print the notes of a project in the order of their frames: what they are about, who says what, the answers, and which
are ticked off. --csv makes a table for spreadsheets."""
EXAMPLES = """\
  kagezou notes cut12.kage
  kagezou notes cut12.kage --open
  kagezou notes cut12.kage --csv -o notes.csv
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("--open", action="store_true", help="only those that are not ticked off")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--csv", action="store_true", help="a table with a heading instead of lines")
    form.add_argument("--json", action="store_true", help="print one object to programs")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write it there instead of printing it")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """List the notes."""
    from dataclasses import replace

    from kagezou.export.note_list import note_rows, notes_as_csv, notes_as_text
    from kagezou.io.files.atomic import write_bytes
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load

    document = load(options.project)
    if options.open:
        document = replace(document, notes=tuple(each for each in document.notes if not each.is_done))
    if options.json:
        give_json({"notes": [_as_json(row) for row in note_rows(document)]})
        return 0
    text = (notes_as_csv if options.csv else notes_as_text)(document, _in_english)
    if options.output is not None:
        write_bytes(options.output, text.encode("utf-8"))
        give(shown(options.output))
    elif text:
        give(text.removeprefix("\ufeff").replace("\r\n", "\n").rstrip("\n"))
    return 0


def _as_json(row: "NoteRow") -> dict[str, Json]:
    note = row.note
    return {
        "frame": note.frame,
        "layer": row.layer or None,
        "property": note.property,
        "text": note.text,
        "author": note.author,
        "answers": [{"author": each.author, "text": each.text} for each in note.answers],
        "done": note.is_done,
    }


def _in_english(text: str, _about: str) -> str:
    return text
