"""One line under the graph: where the pointer is, and what the nearest curve does there."""

from PySide6.QtCore import QCoreApplication

from kagezou.animation.timecode import sheet_text
from kagezou.document.address import track_of
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Document
from kagezou.tools.curves.curve_list import same_in
from kagezou.tools.curves.picture import CurvePicture, value_in
from kagezou.ui.curves.choice import Choice
from kagezou.ui.system.shown_units import shown_unit
from kagezou.ui.system.words import translated


def readout(document: Document, choice: Choice, picture: CurvePicture | None, frame: int) -> str:
    """Return the frame, and of a curve its value, speed, way from the key before, and difference from its ghost."""
    canvas = document.canvas
    where = f"{number_of(canvas, frame)}  ({sheet_text(frame, canvas.frame_rate)})"
    if picture is None:
        return where
    curve = picture.curve
    track = track_of(document, curve.address)
    value, before = (value_in(track, curve.component, each) for each in (frame, frame - 1))
    if value is None or before is None:
        return where
    shown = shown_unit(curve.address.property)
    unit, factor = shown.behind(), shown.factor
    words = [where, f"{translated(curve.address.property.label)} {curve.name}".strip(), f"{value * factor:.4g}{unit}"]
    words.append(f"{(value - before) * factor:+.4g}{unit}/f")
    earlier = [key for key in track.keys if key.frame <= frame]
    if earlier:
        start = value_in(track, curve.component, earlier[-1].frame) or 0.0
        since = QCoreApplication.translate("Readout", "%1 since key %2")
        way = f"{(value - start) * factor:+.4g}{unit}"
        words.append(since.replace("%1", way).replace("%2", str(number_of(canvas, earlier[-1].frame))))
    if choice.ghost is not None and (other := same_in(choice.ghost, curve, document)) is not None:
        there = value_in(other, curve.component, frame)
        if there is not None:
            against = QCoreApplication.translate("Readout", "%1 against the snapshot")
            words.append(against.replace("%1", f"{(value - there) * factor:+.4g}{unit}"))
    return "    ".join(words)
