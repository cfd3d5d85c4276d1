"""Where a new set piece is put: seen, sized from the figure, and where a shadow falls on it that can be read."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from kagezou.document import set_properties as lines
from kagezou.document.model import Document
from kagezou.document.piece_kinds import BUILT_KINDS, TRAITS
from kagezou.document.set_pieces import add_piece, stood_up
from kagezou.geometry.sets.measures import PieceKind
from kagezou.geometry.sight import depth_of, seen
from kagezou.scene.piece_frames import PieceFrame, piece_frame
from kagezou.tools.catching import Flags
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.piece_spots import Neighbours, Spot, best_spot, sized_figure
from kagezou.tools.view import CanvasView
from kagezou.tools.wall_fitting import sides_of
from kagezou.tools.wall_placing import wall_spot


@dataclass(frozen=True, slots=True)
class NewPiece:
    """A piece to be added: its kind, its name, and constants that are settled already, by property name."""

    kind: PieceKind
    name: str
    wanted: Mapping[str, object] = field(default_factory=dict)


def add_placed(
    document: Document,
    frame: int,
    layer_id: str | None,
    new: NewPiece,
    shapes: Mapping[str, Flags] | None = None,
) -> tuple[Document, str]:
    """Return the document with a new piece where it is seen, and the piece's id; figures stand up as it does.

    A wall stands across the canvas behind all figures over the whole cut, and their shadows fit on it. Anything else
    stands where the shadow of the layer's figure falls on it in a readable way, as far as there is such a place.

    Parameters
    ----------
    document, frame
        What is looked at.
    layer_id
        The layer whose figure it is put beside; None for the topmost.
    new
        What is added; :func:`~kagezou.document.set_pieces.add_piece` says what is refused.
    shapes
        The silhouettes of figures on the frame, by the ids of their layers, as far as they are known: which cells of
        its box each fills, (rows, columns).
    """
    document = stood_up(document)
    if layer_id is None and document.layers:
        layer_id = document.layers[-1].id
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    walls, others = (tuple(_others(geometry, is_wall=is_wall)) for is_wall in (True, False))
    if TRAITS[new.kind].is_backdrop:
        spot = _wall(geometry, walls)
    else:
        taken = tuple((each.stand.origin, max(each.measures.width_px, each.measures.depth_px) / 2) for each in others)
        spot = best_spot(geometry, new.kind, shapes or {}, Neighbours(taken, tuple(each.stand for each in walls)))
    values: dict[str, object] = {}
    if spot is not None:
        scale = depth_of(geometry.camera, spot.place)
        x, y = seen(geometry.camera, spot.place)
        values[lines.PIECE_POSITION.name] = (float(round(x)), float(round(y)))
        sized = zip((lines.PIECE_WIDTH, lines.PIECE_HEIGHT, lines.PIECE_DEPTH), spot.size, strict=True)
        values |= {prop.name: float(max(round(size / scale), 1)) for prop, size in sized}
    document = add_piece(document, new.name, new.kind, {**values, **new.wanted})
    return document, document.pieces[-1].id


def _wall(geometry: FrameGeometry, walls: tuple[PieceFrame, ...]) -> Spot | None:
    """Return where a wall stands beside others."""
    sides = sides_of(geometry.document, geometry.frame)
    found = wall_spot(geometry, sides, sized_figure(geometry).height, (each.stand.origin for each in walls))
    return None if found is None else Spot(found.place, (found.width, found.height, 1.0))


def _others(geometry: FrameGeometry, *, is_wall: bool) -> Iterator[PieceFrame]:
    """Yield the walls there are, or all other pieces that are built."""
    for piece in geometry.document.pieces:
        found = piece_frame(piece, geometry.frame, geometry.camera, geometry.ground)
        if found is None or found.measures.kind not in BUILT_KINDS:
            continue
        if TRAITS[found.measures.kind].is_backdrop == is_wall:
            yield found
