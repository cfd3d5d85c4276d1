"""What a person says about feet: pins on the drawings of a layer, so that they hold wherever the drawing is exposed."""

from dataclasses import replace

from kagezou.document.edits import set_drawings
from kagezou.document.model import Document, Drawing
from kagezou.geometry.vectors import Point2
from kagezou.standing.foot import FootPin, Verdict


def pin_of(drawing: Drawing, track: int) -> FootPin | None:
    """Return what a person said about a foot of a drawing, None where nobody did."""
    return next((pin for pin in drawing.pins if pin.track == track), None)


def judge_foot(document: Document, layer_id: str, index: int, track: int, verdict: Verdict | None) -> Document:
    """Say what a foot of a drawing (an index) does; None leaves that to what is found."""
    pin = _pin(document, layer_id, index, track)
    return _with(document, layer_id, index, replace(pin, verdict=verdict))


def place_foot(document: Document, layer_id: str, index: int, track: int, place: Point2) -> Document:
    """Say where a foot of a drawing is, drawing px; a foot that was said to be none is one again."""
    pin = _pin(document, layer_id, index, track)
    verdict = None if pin.verdict is Verdict.NONE else pin.verdict
    return _with(document, layer_id, index, replace(pin, place=place, verdict=verdict))


def put_ground_below(document: Document, layer_id: str, index: int, track: int, row: float) -> Document:
    """Say at which row the ground lies below a lifted foot, drawing px; a foot whose ground is set is lifted."""
    pin = _pin(document, layer_id, index, track)
    return _with(document, layer_id, index, replace(pin, ground_row=row, verdict=Verdict.LIFTED))


def add_foot(document: Document, layer_id: str, index: int, place: Point2) -> Document:
    """Put a foot where none was found, drawing px; it carries."""
    known = [foot.track for drawing in document.layer(layer_id).cels.drawings for foot in drawing.feet or ()]
    pinned = [pin.track for pin in document.layer(layer_id).cels.drawings[index].pins]
    track = max((*known, *pinned), default=-1) + 1
    return _with(document, layer_id, index, FootPin(track, Verdict.PLANTED, place))


def unpin_foot(document: Document, layer_id: str, index: int, track: int) -> Document:
    """Take back what was said about a foot of a drawing; a foot that a person put goes."""
    return _changed(document, layer_id, index, track, ())


def _pin(document: Document, layer_id: str, index: int, track: int) -> FootPin:
    return pin_of(document.layer(layer_id).cels.drawings[index], track) or FootPin(track)


def _with(document: Document, layer_id: str, index: int, pin: FootPin) -> Document:
    return _changed(document, layer_id, index, pin.track, () if pin == FootPin(pin.track) else (pin,))


def _changed(document: Document, layer_id: str, index: int, track: int, pins: tuple[FootPin, ...]) -> Document:
    drawings = document.layer(layer_id).cels.drawings
    drawing = drawings[index]
    others = (pin for pin in drawing.pins if pin.track != track)
    changed = replace(drawing, pins=tuple(sorted((*others, *pins), key=lambda pin: pin.track)))
    return set_drawings(document, layer_id, (*drawings[:index], changed, *drawings[index + 1 :]))
