"""``kagezou inspect``: what any file is understood to be, before anything is made of it."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give, give_json, one_line, tell
from kagezou.errors import Problem

if TYPE_CHECKING:
    from kagezou.importing.inspection import Inspection

DESCRIPTION = (
    "Say what files are understood to be, in words: characters and their drawings in order, the columns of a "
    "timesheet, the triangles and cameras of a set, and what of a file is not used or had to be assumed. "
    "Nothing is written."
)
EXAMPLES = """\
  kagezou inspect drawings/hero
  kagezou inspect 'walk_#.png' cut12.psd cut12.xdts set.glb
  kagezou inspect cut12.psd --json           one object a file, in a list
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument(
        "files",
        type=Path,
        nargs="+",
        metavar="FILE",
        help="a folder, a pattern such as 'walk_#.png', a picture, a PSD file, a timesheet, a set or a project",
    )
    parser.add_argument("--json", action="store_true", help="print one list with an object a file")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Inspect the files one after the other; the exit code is that of the first that cannot be read."""
    from kagezou.importing.inspection import inspected

    code = 0
    objects: list[Json] = []
    for path in options.files:
        try:
            found = inspected(path)
        except Problem as problem:
            code = code or problem.exit_code
            objects.append({"file": str(path), "kind": None, "problem": str(problem)})
            tell(str(problem))
            continue
        objects.append(_object(found))
        if not options.json:
            _give_lines(found)
    if options.json:
        give_json(objects, indent=2)
    return code


def _object(found: "Inspection") -> Json:
    from kagezou.io.files.faults import shown

    notes = [str(note) for note in found.notes]
    return {"file": shown(found.path), "kind": found.kind, **found.facts, "notes": notes}


def _give_lines(found: "Inspection") -> None:
    from kagezou.io.files.faults import shown

    give(one_line(shown(found.path)))
    for line in found.lines:
        give(f"  {one_line(str(line))}")
    for note in found.notes:
        give(f"  note: {one_line(str(note))}")
