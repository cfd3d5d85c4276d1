"""``kagezou retake``: other drawings for a layer, matched with those it had."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kagezou.cli.arguments import Parser, named_source, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import give, give_json, note
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document
    from kagezou.importing.retakes.report import Report

DESCRIPTION = """\
Give a layer other drawings: a folder, a picture, a pattern or a PSD file. Drawings are known again by name and picture,
then by likeness, then by their order between others. Keys, words about feet, exposures and notes stay where they still
make sense; what does not is said. Prints what was not simply the same: the drawing of before, that of now, and by what
it was known again. Markers stand where to look."""
EXAMPLES = """\
  kagezou retake cut12.kage Hero=retakes/r2/hero
  kagezou retake cut12.kage 'Hero=clean/hero_#.png' --dry-run
  kagezou retake cut12.kage Hero=r2/hero --json        everything that came of it
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to change")
    parser.add_argument(
        "drawings", type=named_source, nargs="+", metavar="NAME=FOLDER", help="a layer, and where its drawings are now"
    )
    parser.add_argument("--dry-run", action="store_true", help="only say what would come of it")
    parser.add_argument("--json", action="store_true", help="print one JSON object")


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Read, match, and write the project."""
    from kagezou.io.project.file import load, save

    before = document = load(options.project)
    reports: list[Report] = []
    for name, path in options.drawings:
        document, report, notes = _retaken(document, name, path)
        reports.append(report)
        for each in notes:
            note(each)
    if document != before and not options.dry_run:
        save(document, options.project)
    if options.json:
        give_json({"layers": [as_json(report) for report in reports], "saved": not options.dry_run})
    else:
        for report in reports:
            for line in _lines(report):
                give(line)
    return 0


def _retaken(document: "Document", name: str, path: Path) -> "tuple[Document, Report, tuple[Message, ...]]":
    from kagezou.document.layer_named import layer_named
    from kagezou.importing.new_cels import CharacterSource
    from kagezou.importing.retakes.retake import read_retake, retaken

    layer = layer_named(document, name)
    done = retaken(document, layer.id, read_retake(document, layer.id, [CharacterSource(None, path)]))
    return done.imported.document, done.report, done.imported.notes


def _lines(report: "Report") -> list[str]:
    from kagezou.importing.retakes.matching import How

    rows = (row for row in report.rows if row.how is not How.SAME)
    return [f"{report.name}\t{row.before or '-'}\t{row.after or '-'}\t{_how(row.before, row.how)}" for row in rows]


def _how(before: str | None, how: object) -> str:
    if how is not None:
        return str(how)
    return "new" if before is None else "gone"


def as_json(report: "Report") -> dict[str, Any]:
    """Return everything that came of a retake, for programs."""
    return {
        "layer": report.name,
        "drawings": [
            {"before": row.before, "after": row.after, "how": _how(row.before, row.how)} for row in report.rows
        ],
        "contacts_moved": [
            {"frame": each.frame, "drawing": each.drawing, "away": each.away} for each in report.contacts
        ],
        "look_at": list(report.frames),
        "pins_kept": report.pins_kept,
        "pins_dropped": [{"drawing": drawing, "count": count} for drawing, count in report.pins_dropped],
        "keys_moved": report.keys_moved,
        "keys_dropped": [{"property": prop, "frame": frame} for prop, frame in report.keys_dropped],
        "gone_frames": list(report.gone_frames),
        "unseen": list(report.unseen),
    }
