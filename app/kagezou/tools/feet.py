"""The feet of a figure: where each touches the drawing, and the ground below those in the air.

What a hand does to them is said about the drawing that is shown (a pin), so that it holds wherever that is exposed.
"""

from dataclasses import dataclass

from kagezou.document.feet_edits import (
    add_foot,
    judge_foot,
    pin_of,
    place_foot,
    put_ground_below,
    unpin_foot,
)
from kagezou.document.figures import parts_of
from kagezou.document.model import Document, Layer, drawing_size
from kagezou.geometry.box import centred_offset
from kagezou.geometry.placement import centred_from_canvas
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.scene.figure_card import feet_at
from kagezou.scene.placing import placement_at
from kagezou.scene.stances import TRACKS_OF_A_PART, feet_of, stances_of
from kagezou.standing.foot import FootPin, Verdict
from kagezou.standing.seen import Standing
from kagezou.tools.drag import Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.handle import Cursor, Guide, GuideKind, Handle, HandleShape

FOOT = "foot"
GROUND = "foot_ground"

_PLANTED = Message("Foot, planted")
_LIFTED = Message("Foot, lifted")
_BELOW = Message("Ground below the foot")
_LEAST_HEIGHT_PX = 0.5


@dataclass(frozen=True, slots=True)
class ShownFoot:
    """A foot of a figure as the drawing of a layer that is shown now.

    Parameters
    ----------
    layer
        The layer whose drawing it is: the figure's own, or a part's.
    index, track
        Which drawing of that layer, and which of its feet.
    """

    layer: Layer
    index: int
    track: int

    @property
    def pin(self) -> FootPin | None:
        """What a person said about it."""
        return pin_of(self.layer.cels.drawings[self.index], self.track)


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return the feet of the figure worked on, and the ground below those in the air."""
    made: list[Handle] = []
    for foot in _feet(geometry):
        x, y = foot.place
        if not foot.is_planted and foot.ground_row - y > _LEAST_HEIGHT_PX:
            made.append(_handle(geometry, GROUND, HandleShape.GROUND_MARK, (x, foot.ground_row), foot.track))
        shape = HandleShape.SOLE if foot.is_planted else HandleShape.SOLE_LIFTED
        made.append(_handle(geometry, FOOT, shape, foot.place, foot.track))
    return tuple(made)


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return the way down from each lifted foot."""
    return tuple(
        Guide(GuideKind.FOOT_HEIGHT, (foot.place, (foot.place[0], foot.ground_row)))
        for foot in _feet(geometry)
        if not foot.is_planted and foot.ground_row - foot.place[1] > _LEAST_HEIGHT_PX
    )


def move_foot(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Put a foot under the hand, on the drawing that is shown."""
    foot = shown_foot(geometry.document, handle, geometry.frame)
    if foot is None:
        return geometry.document
    place = on_drawing(geometry.document, foot, geometry.frame, aim.straightened((1.0, 0.0)).target)
    return place_foot(geometry.document, foot.layer.id, foot.index, foot.track, place)


def move_ground(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Put the ground below a lifted foot at the row under the hand."""
    foot = shown_foot(geometry.document, handle, geometry.frame)
    if foot is None:
        return geometry.document
    place = on_drawing(geometry.document, foot, geometry.frame, (handle.canvas_px[0], aim.target[1]))
    return put_ground_below(geometry.document, foot.layer.id, foot.index, foot.track, place[1])


def shown_foot(document: Document, handle: Handle, frame: int) -> ShownFoot | None:
    """Return whose foot a handle is; None for other handles and where its drawing is not shown any more."""
    name = handle.id.partition(".")[0]
    if name not in (FOOT, GROUND) or handle.layer_id is None or handle.index is None:
        return None
    place, track = divmod(handle.index, TRACKS_OF_A_PART)
    parts = parts_of(document, _figure(document, handle.layer_id).id)
    index = parts[place].cels.index_at(frame) if place < len(parts) else None
    return None if index is None else ShownFoot(parts[place], index, track)


def judged(document: Document, foot: ShownFoot, verdict: Verdict | None) -> Document:
    """Return the document in which a foot is planted, lifted, none, or what is found."""
    return judge_foot(document, foot.layer.id, foot.index, foot.track, verdict)


def carries(document: Document, foot: ShownFoot, frame: int) -> bool:
    """Return whether a foot is planted on a frame."""
    figure = _figure(document, foot.layer.id)
    found = stances_of(document, figure.id)
    number = [part.id for part in parts_of(document, figure.id)].index(foot.layer.id) * TRACKS_OF_A_PART + foot.track
    return found is not None and any(each.track == number and each.is_planted for each in found.at(frame).feet)


def kept_in_place(document: Document, foot: ShownFoot) -> Document:
    """Return the document in which a foot stays where it was found, whatever is found later."""
    drawing = document.layer(foot.layer.id).cels.drawings[foot.index]
    at = next((each.place for each, _ in feet_of(drawing) if each.track == foot.track), None)
    return document if at is None else place_foot(document, foot.layer.id, foot.index, foot.track, at)


def unpinned(document: Document, foot: ShownFoot) -> Document:
    """Return the document without what was said about a foot."""
    return unpin_foot(document, foot.layer.id, foot.index, foot.track)


def with_foot_at(document: Document, layer_id: str, frame: int, canvas_px: Point2) -> Document | None:
    """Return the document with one more foot on the drawing that is shown; None where none is."""
    layer = document.layer(layer_id)
    index = layer.cels.index_at(frame)
    if index is None:
        return None
    place = on_drawing(document, ShownFoot(layer, index, 0), frame, canvas_px)
    return add_foot(document, layer_id, index, place)


def on_drawing(document: Document, foot: ShownFoot, frame: int, canvas_px: Point2) -> Point2:
    """Return a canvas point in px of the drawing that a foot is on."""
    drawing = foot.layer.cels.drawings[foot.index]
    left, top = centred_offset(document.canvas.box, *drawing_size(document.canvas, drawing))
    x, y, _ = centred_from_canvas(placement_at(document, foot.layer, frame)) @ (*canvas_px, 1.0)
    return (float(x) - left, float(y) - top)


def _feet(geometry: FrameGeometry) -> tuple[Standing, ...]:
    """Return the feet of the figure worked on, where it stands on them."""
    if geometry.layer is None:
        return ()
    figure = _figure(geometry.document, geometry.layer.id)
    found = stances_of(geometry.document, figure.id)
    if found is None or feet_at(geometry.document, figure, geometry.frame) is None:
        return ()
    return found.at(geometry.frame).feet


def _figure(document: Document, layer_id: str) -> Layer:
    layer = document.layer(layer_id)
    return layer if layer.joins is None else document.layer(layer.joins)


def _handle(geometry: FrameGeometry, name: str, shape: HandleShape, at: Point2, track: int) -> Handle:
    assert geometry.layer is not None
    label = _BELOW if name == GROUND else _PLANTED if shape is HandleShape.SOLE else _LIFTED
    cursor = Cursor.VERTICAL if name == GROUND else Cursor.MOVE
    return Handle(f"{name}.{track}", shape, at, None, label, cursor, layer_id=geometry.layer.id, index=track)
