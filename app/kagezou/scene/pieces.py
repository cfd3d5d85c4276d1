"""The set of one frame: where its pieces stand, what they are made of, and the shadow they cast themselves."""

from dataclasses import dataclass
from functools import lru_cache

from kagezou.animation.track import Value
from kagezou.document import set_properties as lines
from kagezou.document.model import Document, Piece
from kagezou.document.property import Property
from kagezou.geometry import piece_shapes as shapes
from kagezou.geometry.camera import Camera
from kagezou.geometry.ground import Plane, place_on
from kagezou.geometry.pieces import Body
from kagezou.geometry.vectors import Point2, Vector4


@dataclass(frozen=True, slots=True)
class PieceScene:
    """A set piece of one frame.

    Parameters
    ----------
    id, name
        Those of the document's piece.
    bodies
        What it is made of.
    receives
        Whether the characters' shadows fall on it.
    blocks
        Whether they end where it takes the light.
    casts
        Whether its own shadow is drawn.
    """

    id: str
    name: str
    bodies: tuple[Body, ...]
    receives: bool
    blocks: bool
    casts: bool


@dataclass(frozen=True, slots=True)
class SetCast:
    """All that decides the shadow of the set itself; equal casts have equal pixels.

    Parameters
    ----------
    camera, ground
        What it is seen with and stands on.
    pieces
        All there are; those that cast throw the shadow, and all of them receive and hide it.
    lights
        Homogeneous, over the ground.
    """

    camera: Camera
    ground: Plane
    pieces: tuple[PieceScene, ...]
    lights: tuple[Vector4, ...]


@dataclass(frozen=True, slots=True)
class _Measures:
    """What a piece is built from: its sizes in world px, angles in degrees."""

    kind: str
    width: float
    height: float
    depth: float
    angle: float
    lean: float
    count: int


def pieces_at(document: Document, frame: float, camera: Camera, ground: Plane) -> tuple[PieceScene, ...]:
    """Return the set of a frame; pieces that are switched off or placed above the horizon are left out."""
    scenes = (_piece_scene(piece, frame, camera, ground) for piece in document.pieces)
    return tuple(scene for scene in scenes if scene is not None)


def _piece_scene(piece: Piece, frame: float, camera: Camera, ground: Plane) -> PieceScene | None:
    if not _value(piece, lines.PIECE_PRESENT, frame):
        return None
    position = _value(piece, lines.PIECE_POSITION, frame)
    x, y = (part for part in position if isinstance(part, float)) if isinstance(position, tuple) else (0.0, 0.0)
    numbers = (lines.PIECE_WIDTH, lines.PIECE_HEIGHT, lines.PIECE_DEPTH, lines.PIECE_ANGLE, lines.PIECE_LEAN)
    width, height, depth, angle, lean = (_number(piece, line, frame) for line in numbers)
    count = round(_number(piece, lines.PIECE_COUNT, frame))
    measures = _Measures(str(_value(piece, lines.PIECE_KIND, frame)), width, height, depth, angle, lean, count)
    bodies = _bodies(measures, (x, y), camera, ground)
    if not bodies:
        return None
    casts = bool(_value(piece, lines.PIECE_CASTS, frame))
    return PieceScene(
        piece.id,
        piece.name,
        bodies,
        receives=bool(_value(piece, lines.PIECE_RECEIVES, frame)),
        blocks=casts or bool(_value(piece, lines.PIECE_BLOCKS, frame)),
        casts=casts,
    )


@lru_cache(maxsize=256)
def _bodies(measures: _Measures, position: Point2, camera: Camera, ground: Plane) -> tuple[Body, ...]:
    """Return what a piece is made of; nothing above the horizon."""
    place = place_on(camera, ground, position)
    if place is None:
        return ()
    # Sizes are told as they are seen at that depth: one px of the canvas is this many px of the world there.
    scale = float(camera.canvas_from_world()[2] @ (*place, 1.0))
    width, height, depth = (size * scale for size in (measures.width, measures.height, measures.depth))
    stand = shapes.stand_on(ground, place, measures.angle)
    match measures.kind:
        case "box":
            return shapes.box(stand, width, depth, height)
        case "steps":
            return shapes.steps(stand, width, depth, height, measures.count)
        case "ramp":
            return shapes.ramp(stand, width, depth, height)
        case "cylinder":
            return shapes.drum(stand, width, height)
        case "sphere":
            return shapes.ball(stand, width)
        case _:
            return shapes.wall(stand, width, height, measures.lean)


def _value(piece: Piece, line: Property, frame: float) -> Value:
    track = piece.tracks.get(line.name)
    return line.default if track is None else track.value_at(frame)


def _number(piece: Piece, line: Property, frame: float) -> float:
    value = _value(piece, line, frame)
    assert isinstance(value, float), value
    return value
