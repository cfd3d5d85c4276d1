"""The sizes of a set piece: its sides are drawn out along its width, its depth and its height.

Each grip moves along one line of the piece; the hand means the place on that line which is seen nearest to it. Sizes
grow to both sides of where the piece stands.
"""

from math import cos, radians, sin

from kagezou.document import set_properties as lines
from kagezou.document.model import Document
from kagezou.document.piece_kinds import TRAITS, matters
from kagezou.document.property import Property
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Vector3
from kagezou.scene.piece_frames import PieceFrame
from kagezou.scene.set_outlines import outlines_of
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape
from kagezou.tools.sight import moved, part_seen_at

WIDTH = "piece.width"
DEPTH = "piece.depth"
HEIGHT = "piece.height"

_SIZES: dict[str, Property[float]] = {WIDTH: lines.PIECE_WIDTH, DEPTH: lines.PIECE_DEPTH, HEIGHT: lines.PIECE_HEIGHT}
_CURSORS = {WIDTH: Cursor.HORIZONTAL, DEPTH: Cursor.VERTICAL, HEIGHT: Cursor.VERTICAL}


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the grips of the piece worked on."""
    piece = geometry.piece
    if piece is None:
        return ()
    return tuple(
        Handle(
            handle_id, HandleShape.GRIP, seen(geometry.camera, _end(piece, handle_id)),
            geometry.address(_SIZES[handle_id]), _SIZES[handle_id].label, _CURSORS[handle_id],
            stays_in_view=True, piece_id=piece.id,
        )
        for handle_id in (DEPTH, HEIGHT, WIDTH)
        if matters(_SIZES[handle_id], piece.measures.kind)
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the edges of the whole set: those of a piece that is worked on, faintly those of all others."""
    made: list[Guide] = []
    for outline in outlines_of(geometry.document, geometry.frame):
        if outline.piece_id == geometry.piece_id:
            made += [Guide(GuideKind.PIECE_HIDDEN, line) for line in outline.hidden]
            made += [Guide(GuideKind.PIECE_EDGE, line) for line in outline.seen]
        else:
            made += [Guide(GuideKind.PIECE_OTHER, line) for line in outline.seen]
            made += [Guide(GuideKind.PIECE_FLOOR, line) for line in outline.floor]
    return tuple(made)


def move_size(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Draw a side out, or push it in; constrained, the piece keeps its proportions.

    Seen end-on, the hand's way down draws it out.
    """
    piece, prop = geometry.piece, _SIZES[handle.id]
    if piece is None:
        return geometry.document
    base, way = _line(piece, handle.id)
    size = part_seen_at(geometry.camera, base, way, aim.target)
    if size is None:
        (x, y), (across_x, across_y) = aim.offset, geometry.across
        size = geometry.value(prop) + x * across_x + y * across_y
    document = geometry.edited(prop, size)
    if aim.modifiers.constrain:
        grown = max(size, prop.low) / geometry.value(prop)
        for other in _SIZES.values():
            if other is not prop and matters(other, piece.measures.kind):
                document = geometry.edited(other, grown * geometry.value(other), document)
    return document


def _line(piece: PieceFrame, handle_id: str) -> tuple[Vector3, Vector3]:
    """Return where the line begins on which a grip lies, and the way on it for one px of the property, world px."""
    stand, measures, scale = piece.stand, piece.measures, piece.scale
    nowhere: Vector3 = (0.0, 0.0, 0.0)
    if handle_id == DEPTH:
        return stand.origin, moved(nowhere, (scale / 2, stand.v))
    if handle_id == WIDTH and matters(lines.PIECE_HEIGHT, measures.kind):
        return stand.origin, moved(nowhere, (scale / 2, stand.u))
    if handle_id == WIDTH:
        # What has no height of its own is as high as it is wide, and widest halfway up.
        return stand.origin, moved(nowhere, (scale / 2, stand.u), (scale / 2, stand.normal))
    if matters(lines.PIECE_LEAN, measures.kind):
        lean = radians(measures.lean_deg)
        return stand.origin, moved(nowhere, (scale * cos(lean), stand.normal), (-scale * sin(lean), stand.v))
    back = measures.depth_px / 2 if TRAITS[measures.kind].rises_to_back else 0.0
    return moved(stand.origin, (-back, stand.v)), moved(nowhere, (scale, stand.normal))


def _end(piece: PieceFrame, handle_id: str) -> Vector3:
    measures = piece.measures
    sizes = {WIDTH: measures.width_px, DEPTH: measures.depth_px, HEIGHT: measures.height_px}
    base, way = _line(piece, handle_id)
    return moved(base, (sizes[handle_id] / piece.scale, way))
