"""The grounding points of a layer: where the character touches the ground."""

from dataclasses import replace

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.geometry.sight import seen
from kagezou.geometry.vectors import Point2
from kagezou.message import Message
from kagezou.tools.drag import SNAP_VIEW_PX, Aim
from kagezou.tools.frame_geometry import FrameGeometry
from kagezou.tools.ground import kept_near
from kagezou.tools.handle import Guide, GuideKind, Handle, HandleShape
from kagezou.tools.view import CanvasView

GROUNDING = "grounding"
"""The ids of these handles are this, a dot and the point's place in the list."""


def handles(geometry: FrameGeometry) -> tuple[Handle, ...]:
    """Return a handle for each grounding point of the layer worked on."""
    if geometry.layer is None:
        return ()
    return tuple(
        Handle(
            f"{GROUNDING}.{index}", HandleShape.DIAMOND, point, geometry.address(properties.GROUNDING),
            Message("Grounding point {number}", number=index + 1),
            layer_id=geometry.layer.id, index=index,
        )
        for index, point in enumerate(geometry.value(properties.GROUNDING))
    )  # fmt: skip


def guides(geometry: FrameGeometry) -> tuple[Guide, ...]:
    """Return where the card meets the ground, with two contacts or more."""
    if geometry.card is None or len(geometry.card.contacts) < 2:
        return ()
    return (Guide(GuideKind.CARD_FOOT, tuple(seen(geometry.camera, place) for place in geometry.card.contacts)),)


def move_point(geometry: FrameGeometry, handle: Handle, aim: Aim) -> Document:
    """Move one point: constrained along its row, symmetric against the other one of two.

    It is drawn to the rows of the other points, so that a figure stands square to the viewer, and to the ground line.
    """
    points = list(geometry.value(properties.GROUNDING))
    index = handle.index
    if index is None or index >= len(points):
        return geometry.document
    start = points[index]
    if aim.modifiers.constrain:
        aim = replace(aim, target=(aim.target[0], start[1]))
    elif aim.modifiers.snap:
        rows = [point[1] for other, point in enumerate(points) if other != index]
        aim = replace(aim, target=_drawn(geometry, aim.target, rows))
    points[index] = kept_near(aim.target)
    if aim.modifiers.symmetric and len(points) == 2:
        x, y = points[1 - index]
        points[1 - index] = kept_near((x - points[index][0] + start[0], y - points[index][1] + start[1]))
    return geometry.edited(properties.GROUNDING, tuple(points))


def add_grounding(document: Document, layer_id: str, frame: int, canvas_px: Point2) -> Document:
    """Put another grounding point behind those there are; the property's limit raises UsageProblem."""
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    return geometry.edited(properties.GROUNDING, (*geometry.value(properties.GROUNDING), kept_near(canvas_px)))


def remove_grounding(document: Document, layer_id: str, frame: int, index: int) -> Document:
    """Take the grounding point at a place in the list away; the same document where there is none."""
    geometry = FrameGeometry.of(document, frame, layer_id, CanvasView())
    points = geometry.value(properties.GROUNDING)
    if not 0 <= index < len(points):
        return document
    return geometry.edited(properties.GROUNDING, points[:index] + points[index + 1 :])


def _drawn(geometry: FrameGeometry, target: Point2, rows: list[float]) -> Point2:
    """Return the target at the nearest row within snapping distance; the ground line counts as a row at its place."""
    (x, y), (gx, gy), (run, rise) = target, geometry.ground.origin[:2], geometry.along
    line = [gy + (x - gx) * rise / run] if run > 1e-3 else []
    near = min((*rows, *line), key=lambda row: abs(row - y), default=y)
    return (x, near) if abs(near - y) <= geometry.view.canvas_length(SNAP_VIEW_PX) else target
