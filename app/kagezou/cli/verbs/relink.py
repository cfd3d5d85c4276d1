"""``kagezou relink``: drawings that are not where they were, found in another folder."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import give, give_json, note, one_line

DESCRIPTION = """\
Find drawings and pictures of the background that are missing, by their names, in a folder or below it: the one that is
searched, else the project's own. Prints what was found where. The exit code is 3 while any is missing."""
EXAMPLES = """\
  kagezou relink cut12.kage
  kagezou relink cut12.kage --search /server/ep03/cels
  kagezou relink cut12.kage --search new --layer Hero --dry-run
"""

STILL_MISSING = 3
"""The exit code where a file that is needed is missing."""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to change")
    parser.add_argument("--search", type=Path, metavar="DIR", help="where to look, folders below it included")
    parser.add_argument("--layer", action="append", metavar="NAME", help="only this layer; may be given again")
    parser.add_argument("--dry-run", action="store_true", help="only say what would be found")
    parser.add_argument("--json", action="store_true", help="print one JSON object")


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Search, and write the project if anything was found."""
    from kagezou.document.layer_named import layer_named
    from kagezou.importing.relinking import found_again, missing_of, relinked
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load, save
    from kagezou.message import Message

    project: Path = options.project
    before = load(project)
    meant = options.layer and [layer_named(before, name).id for name in options.layer]
    ids = meant or [layer.id for layer in before.layers]
    missing = missing_of(before, ids, behind=not meant)
    if not missing:
        note(Message("no drawing is missing"))
        if options.json:
            give_json({"found": [], "missing": []})
        return 0
    again = found_again(missing, options.search or project.resolve().parent)
    document, notes = relinked(before, ids, again, behind=not meant)
    for each in notes:
        note(each)
    if not options.dry_run:
        save(document, project)
    left = [path for path in missing if path not in again.found]
    if options.json:
        found = [{"before": str(old), "after": str(new)} for old, new in again.found.items()]
        give_json({"found": found, "missing": [str(path) for path in left]})
    else:
        for old, new in again.found.items():
            give(one_line(f"{shown(old)}\t{shown(new)}"))
    return STILL_MISSING if left else 0
