"""``kagezou piece``: walls, boxes, steps and the like on the ground, and sets from files; they receive shadows."""

from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, did_you_mean, point, positive, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import give, note
from kagezou.errors import UsageProblem
from kagezou.geometry.sets.measures import PieceKind
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document

DESCRIPTION = """\
Put a piece into the set, take one out, rename or copy it, or list them. A new wall spans the canvas behind the
characters, where their shadows bend up it and fit on it; any other piece stands where the topmost character's shadow
falls on it and can be read, as far as there is such a place. All are sized from the characters, who stand upright from
then on as the set does (layers.NAME.upright). kagezou set changes everything about it: set.NAME.position,
.angle, .lean, .width, .height, .depth, .count, .receives, .blocks, .casts, .kind and .present, for the whole cut or by
keys.

A mesh is a set from a file (glTF, OBJ, PLY, STL; USD where that package is installed). With --camera the canvas camera
follows one of the file's cameras, and the ground goes through the set where the character stands."""
EXAMPLES = """\
  kagezou piece walk.kage add back wall
  kagezou piece walk.kage add stairs steps position=700,820 angle=30 count=5
  kagezou set walk.kage set.back.angle=20 set.back.casts=true
  kagezou piece walk.kage add street mesh --file street.glb
  kagezou piece walk.kage add street mesh --file street.glb --camera shot_010 --stand 960,870
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
        default=[],
        metavar="KIND | NEW_NAME | PROPERTY=JSON",
        help=f"to add: {_kinds()}, then its properties; to rename: the new name",
    )
    parser.add_argument("--file", type=Path, metavar="SET.glb", help="the file of a mesh")
    parser.add_argument("--camera", metavar="NAME", help="the camera of the file that the canvas camera follows")
    parser.add_argument(
        "--stand", type=point, metavar="X,Y", help="where a character stands on it, canvas px (the ground's position)"
    )
    parser.add_argument(
        "--scale",
        type=positive,
        metavar="PX",
        help="canvas px for one unit of the file where it stands; a camera that is followed settles it",
    )
    parser.add_argument("--up", choices=("y", "z"), help="the axis of the file that points up (what the file says)")


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Load, change, and write the project if it changed."""
    from kagezou.document.set_pieces import stood_up_notes
    from kagezou.io.project.file import load, save
    from kagezou.scene.heavy_sets import heavy_notes
    from kagezou.scene.misfits import misfits_of, new_misfits
    from kagezou.tools.wall_placing import cut_notes

    before = load(options.project)
    if options.action == "list":
        _list(before)
        return 0
    if options.name is None:
        raise UsageProblem(Message("which piece is to {action}? (see kagezou piece --help)", action=options.action))
    of_mesh = (options.file, options.camera, options.stand, options.up, options.scale)
    if options.action == "add" and options.words[:1] == [PieceKind.MESH]:
        after = _imported(before, options)
    elif any(each is not None for each in of_mesh):
        raise UsageProblem(Message("--file, --camera, --stand, --up and --scale belong to: add NAME mesh"))
    else:
        after = _changed(before, options.action, options.name, options.words)
    if after is before:
        return 0
    if options.action == "add" and options.words[:1] != [PieceKind.MESH]:
        for sentence in (*stood_up_notes(before, after), *cut_notes(before, after)):
            note(sentence)
    misfits = new_misfits(misfits_of(before), misfits_of(after))
    for sentence in (*heavy_notes(before, after), *(misfit.message for misfit in misfits)):
        note(sentence)
    save(after, options.project)
    return 0


def _changed(document: "Document", action: str, name: str, words: list[str]) -> "Document":
    from kagezou.document.set_pieces import copy_piece, remove_piece, rename_piece

    if action == "add":
        return _added(document, name, words)
    piece_id = _id_of(document, name)
    if action == "rename":
        if len(words) != 1:
            raise UsageProblem(Message("rename takes the old name and the new one"))
        return rename_piece(document, piece_id, words[0])
    if words:
        raise UsageProblem(Message("{words!r} is not expected here (see kagezou piece --help)", words=words[0]))
    return remove_piece(document, piece_id) if action == "remove" else copy_piece(document, piece_id)


def _imported(document: "Document", options: Namespace) -> "Document":
    from kagezou.document.address import Address
    from kagezou.document.edits import set_constant
    from kagezou.document.properties import OF_PIECE
    from kagezou.importing.imported_sets import SetImport, import_set
    from kagezou.io.sets.mesh_cache import MeshCache

    if options.file is None:
        raise UsageProblem(Message("which file is the mesh to be read from? --file SET.glb"))
    if options.camera is not None and options.scale is not None:
        raise UsageProblem(Message("--camera settles the size of the set: leave out --scale, or the camera"))
    values = _values(options.words[1:])
    how = (options.camera, options.stand, options.up, options.scale)
    wanted = SetImport(options.file.absolute(), options.name, *how)
    imported = import_set(document, wanted, MeshCache())
    for sentence in imported.notes:
        note(sentence)
    document = imported.document
    for name, value in values.items():
        if name not in OF_PIECE:
            raise UsageProblem(Message("a set piece has no property {name!r}", name=name))
        document = set_constant(document, Address(OF_PIECE[name], piece_id=imported.piece_id), value)
    return document


def _added(document: "Document", name: str, words: list[str]) -> "Document":
    from kagezou.document.set_properties import PIECE_KIND
    from kagezou.importing.silhouettes import silhouettes_of
    from kagezou.tools.placing import NewPiece, add_placed

    kind = words[0] if words else ""
    if kind not in PIECE_KIND.choices:
        known = f"one of {', '.join(PIECE_KIND.choices)}"
        raise UsageProblem(
            Message(
                "a set piece is {known}, not {kind!r}{kind_2}",
                known=known,
                kind=kind,
                kind_2=did_you_mean(kind, PIECE_KIND.choices),
            )
            if kind
            else Message("add what? {known}", known=known)
        )
    new = NewPiece(PieceKind(kind), name, _values(words[1:]))
    return add_placed(document, 1, None, new, silhouettes_of(document, 1))[0]


def _kinds() -> str:
    *others, last = PieceKind
    return f"{', '.join(others)} or {last}"


def _values(words: list[str]) -> dict[str, object]:
    from kagezou.document.value_words import value_of_text

    values: dict[str, object] = {}
    for text in words:
        name, sign, value = text.partition("=")
        if not sign:
            raise UsageProblem(Message("{text!r} is not PROPERTY=JSON, such as angle=30", text=text))
        values[name.strip()] = value_of_text(name.strip(), value.strip())
    return values


def _list(document: "Document") -> None:
    from kagezou.document.piece_kinds import kind_of
    from kagezou.io.files.faults import shown

    for piece in document.pieces:
        file = "" if piece.source is None else f"\t{shown(piece.source)}"
        give(f"{kind_of(piece)}\t{piece.name}{file}")


def _id_of(document: "Document", name: str) -> str:
    names = {piece.name: piece.id for piece in document.pieces}
    if name not in names:
        known = ", ".join(repr(each) for each in names) or "none at all"
        raise UsageProblem(
            Message("there is no set piece {name!r} in this project, only {known}", name=name, known=known)
        )
    return names[name]
