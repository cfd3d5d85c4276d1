"""``kagezou piece``: walls, boxes, steps and the like that stand on the ground and receive shadows."""

from argparse import Namespace
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, did_you_mean, project_path
from kagezou.cli.doors import Doors
from kagezou.cli.terminal import give
from kagezou.errors import UsageProblem

if TYPE_CHECKING:
    from kagezou.document.model import Document

DESCRIPTION = """\
Put a piece into the set, take one out, rename or copy it, or list them. A new piece stands behind the characters in a
natural size; kagezou set changes everything about it: set.NAME.position, .angle, .lean, .width, .height, .depth,
.count, .receives, .blocks, .casts, .kind and .present, for the whole cut or by keys."""
EXAMPLES = """\
  kagezou piece walk.kage add back wall
  kagezou piece walk.kage add stairs steps position=[700,820] angle=30 count=5
  kagezou set walk.kage set.back.angle=20 set.back.casts=true
  kagezou piece walk.kage rename back fence
  kagezou piece walk.kage copy stairs
  kagezou piece walk.kage remove stairs
  kagezou piece walk.kage list
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to change")
    parser.add_argument("action", choices=("add", "remove", "rename", "copy", "list"), help="what to do")
    parser.add_argument("name", nargs="?", metavar="NAME", help="the piece")
    parser.add_argument(
        "words",
        nargs="*",
        metavar="KIND | NEW_NAME | PROPERTY=JSON",
        help="to add: wall, box, steps, ramp, cylinder or sphere, then its properties; to rename: the new name",
    )


def run(options: Namespace, doors: Doors) -> int:  # noqa: ARG001 - every verb is called alike
    """Load, change, and write the project if it changed."""
    from kagezou.io.project_file import load, save

    before = load(options.project)
    if options.action == "list":
        _list(before)
        return 0
    if options.name is None:
        raise UsageProblem(f"which piece is to {options.action}? (see kagezou piece --help)")
    after = _changed(before, options.action, options.name, options.words)
    if after is not before:
        save(after, options.project)
    return 0


def _changed(document: "Document", action: str, name: str, words: list[str]) -> "Document":
    from kagezou.document.set_pieces import copy_piece, remove_piece, rename_piece

    if action == "add":
        return _added(document, name, words)
    piece_id = _id_of(document, name)
    if action == "rename":
        if len(words) != 1:
            raise UsageProblem("rename takes the old name and the new one")
        return rename_piece(document, piece_id, words[0])
    if words:
        raise UsageProblem(f"{words[0]!r} is not expected here (see kagezou piece --help)")
    return remove_piece(document, piece_id) if action == "remove" else copy_piece(document, piece_id)


def _added(document: "Document", name: str, words: list[str]) -> "Document":
    from kagezou.cli.values import value_of_text
    from kagezou.document.set_pieces import add_piece
    from kagezou.document.set_properties import BUILT_KINDS as KINDS

    kind = words[0] if words else ""
    if kind not in KINDS:
        known = f"one of {', '.join(KINDS)}"
        raise UsageProblem(
            f"a set piece is {known}, not {kind!r}{did_you_mean(kind, KINDS)}" if kind else f"add what? {known}"
        )
    values: dict[str, object] = {}
    for text in words[1:]:
        line, sign, value = text.partition("=")
        if not sign:
            raise UsageProblem(f"{text!r} is not PROPERTY=JSON, such as angle=30")
        values[line.strip()] = value_of_text(line.strip(), value.strip())
    return add_piece(document, name, kind, values)


def _list(document: "Document") -> None:
    from kagezou.document.set_pieces import kind_of

    for piece in document.pieces:
        give(f"{kind_of(piece)}\t{piece.name}")


def _id_of(document: "Document", name: str) -> str:
    names = {piece.name: piece.id for piece in document.pieces}
    if name not in names:
        known = ", ".join(repr(each) for each in names) or "none at all"
        raise UsageProblem(f"there is no set piece {name!r} in this project, only {known}")
    return names[name]
