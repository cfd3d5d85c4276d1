"""One line under the graph: where the pointer is, and what the nearest curve does there."""

from kagezou.document.address import track_of
from kagezou.document.model import Document
from kagezou.ui.curves.choice import Choice
from kagezou.ui.curves.curve_list import same_in
from kagezou.ui.curves.picture import CurvePicture, value_in
from kagezou.ui.timecode import sheet_text
from kagezou.ui.words import said


def readout(document: Document, choice: Choice, picture: CurvePicture | None, frame: int) -> str:
    """Return the frame, and of a curve its value, speed, way from the key before, and difference from its ghost."""
    where = f"{frame}  ({sheet_text(frame, document.canvas.frame_rate)})"
    if picture is None:
        return where
    curve = picture.curve
    track = track_of(document, curve.address)
    value, before = (value_in(track, curve.component, each) for each in (frame, frame - 1))
    if value is None or before is None:
        return where
    unit = f" {curve.address.property.unit}" if curve.address.property.unit else ""
    words = [where, f"{said(curve.address.property.label)} {curve.name}".strip(), f"{value:.4g}{unit}"]
    words.append(f"{value - before:+.4g}{unit}/f")
    earlier = [key for key in track.keys if key.frame <= frame]
    if earlier:
        start = value_in(track, curve.component, earlier[-1].frame) or 0.0
        words.append(f"Δ {value - start:+.4g} @ {earlier[-1].frame}")
    if choice.ghost is not None and (other := same_in(choice.ghost, curve, document)) is not None:
        there = value_in(other, curve.component, frame)
        if there is not None:
            words.append(f"Δ▒ {value - there:+.4g}")
    return "    ".join(words)
