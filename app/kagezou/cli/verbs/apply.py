"""``kagezou apply``: light, looks, ground and set of one project for others."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import held_project
from kagezou.cli.terminal import give, give_json, note, one_line, tell
from kagezou.errors import Problem, UsageProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document
    from kagezou.document.taking import Part

DESCRIPTION = """\
Take light, looks, ground or the set of one project into others, with their keys; on canvases of other sizes they are
scaled. Looks go from character to character by name, in the measure of their heights. Drawings, timing and feet of the
others stay. Goes on after a project that cannot be changed; prints each one that was."""
EXAMPLES = """\
  kagezou apply c001.kage c002.kage c003.kage --light --look
  kagezou apply master.kage ep03/*.kage --light --ground --set --dry-run
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("source", type=project_path, metavar="FROM.kage", help="the project that is taken from")
    parser.add_argument("targets", type=project_path, nargs="+", metavar="TO.kage", help="the projects to change")
    parser.add_argument("--light", action="store_true", help="its light, and whether shadows unite")
    parser.add_argument("--look", action="store_true", help="the looks of its characters' shadows")
    parser.add_argument("--ground", action="store_true", help="its ground and the camera's field of view")
    parser.add_argument("--set", action="store_true", help="its set pieces, in the place of those there are")
    parser.add_argument("--dry-run", action="store_true", help="only say which projects would change")
    parser.add_argument("--json", action="store_true", help="print one JSON object")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Change one project after the other."""
    from kagezou.document.taking import Part
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load

    parts = frozenset(part for part in Part if getattr(options, part.value))
    if not parts:
        raise UsageProblem(Message("what is taken? --light, --look, --ground or --set"))
    source = load(options.source)
    code = 0
    results: list[dict[str, str | bool]] = []
    for path in options.targets:
        try:
            is_changed = _applied(path, source, parts, is_kept=not options.dry_run)
        except Problem as problem:
            tell(str(problem))
            code = code or problem.exit_code
            results.append({"project": str(path), "changed": False, "problem": str(problem)})
            continue
        results.append({"project": str(path), "changed": is_changed})
        if is_changed and not options.json:
            give(one_line(shown(path)))
    if options.json:
        give_json({"code": code, "projects": results})
    return code


def _applied(path: Path, source: "Document", parts: "frozenset[Part]", *, is_kept: bool) -> bool:
    from kagezou.document.taking import taken
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load, save

    load(path)  # Before a lock is made beside a project that is not there.
    with held_project(path):
        before = load(path)
        done = taken(before, source, parts)
        for sentence in done.notes:
            note(Message("{path}: {note}", path=shown(path), note=sentence))
        if is_kept and done.document != before:
            save(done.document, path)
    return done.document != before
