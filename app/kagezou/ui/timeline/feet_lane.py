"""A figure's row of feet: where each is planted, when the figure is in the air, what is pinned, what is doubtful."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from PySide6.QtCore import QCoreApplication, QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QBrush, QColor, QPainter, QPen, QPolygonF

from kagezou.document.figures import parts_of
from kagezou.document.model import Document
from kagezou.scene.stances import FigureStances
from kagezou.ui.system.theme import BRIGHT, CHANGED, DIM, LINE, SELECTED, WARNING
from kagezou.ui.timeline.time_scale import TimeScale

_PLANTED = QColor("#7a9a7a")
_AIR = QColor(86, 180, 233, 60)
_MARK_PX = 4.5

translate = QCoreApplication.translate


@dataclass(frozen=True, slots=True)
class FootSpan:
    """Frames over which one foot does the same; ``end`` is the first frame after them."""

    track: int
    frame: int
    end: int
    is_planted: bool


@dataclass(frozen=True, slots=True)
class FeetOverTime:
    """What the row of a figure shows.

    Parameters
    ----------
    spans
        By foot and time.
    tracks
        The feet, one strip each, from the top.
    flights
        Frames (first, end) in which the figure is in the air.
    doubts, pinned
        Frames on which drawings begin that are doubtful, and of which a person said something.
    """

    spans: tuple[FootSpan, ...]
    tracks: tuple[int, ...]
    flights: tuple[tuple[int, int], ...]
    doubts: tuple[int, ...]
    pinned: tuple[int, ...]


def feet_over_time(document: Document, figure_id: str, found: FigureStances) -> FeetOverTime:
    """Return what is shown of a figure's feet."""
    ends = (*found.frames[1:], document.canvas.length_frames + 1)
    runs = list(zip(found.frames, ends, found.stances, strict=True))
    tracks = tuple(sorted({foot.track for stance in found.stances for foot in stance.feet}))
    spans = [FootSpan(foot.track, start, end, foot.is_planted) for start, end, stance in runs for foot in stance.feet]
    flights = [(start, end) for start, end, stance in runs if stance.lift_px > 0]
    return FeetOverTime(
        tuple(_joined(spans, tracks)), tracks, tuple(_merged(flights)), found.doubtful, _pinned(document, figure_id)
    )


def _pinned(document: Document, figure_id: str) -> tuple[int, ...]:
    """Return the frames on which drawings begin of which a person said something."""
    frames = {
        max(exposure.frame, 1)
        for layer in parts_of(document, figure_id)
        for exposure in layer.cels.exposures
        if exposure.drawing is not None and layer.cels.drawings[exposure.drawing].pins
    }
    return tuple(sorted(frames))


def _joined(spans: list[FootSpan], tracks: tuple[int, ...]) -> Iterator[FootSpan]:
    """Yield the spans of each foot with those that go on as they are as one."""
    for track in tracks:
        own = [span for span in spans if span.track == track]
        begin = own[0]
        for before, span in pairwise(own):
            if before.end != span.frame or before.is_planted != span.is_planted:
                yield FootSpan(track, begin.frame, before.end, begin.is_planted)
                begin = span
        yield FootSpan(track, begin.frame, own[-1].end, begin.is_planted)


def _merged(runs: list[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    first: int | None = None
    last = 0
    for start, end in runs:
        if first is not None and start != last:
            yield first, last
            first = None
        first, last = start if first is None else first, end
    if first is not None:
        yield first, last


def paint_feet(painter: QPainter, shown: FeetOverTime, scale: TimeScale, band: QRectF) -> None:
    """Paint the row into a band: a strip a foot, filled where it carries; flights are hatched over all strips."""
    for first, end in shown.flights:
        area = QRectF(scale.x_of(first), band.top() + 1, scale.x_of(end) - scale.x_of(first), band.height() - 3)
        painter.fillRect(area, _AIR)
        painter.fillRect(area, QBrush(CHANGED, Qt.BrushStyle.BDiagPattern))
    strip = (band.height() - 4) / max(len(shown.tracks), 1)
    for span in shown.spans:
        left, right = scale.x_of(span.frame), scale.x_of(span.end)
        if right <= 0 or left >= band.right():
            continue
        middle = band.top() + 2 + (shown.tracks.index(span.track) + 0.5) * strip
        if span.is_planted:
            high = min(strip - 1, 7.0)
            painter.fillRect(QRectF(left + 0.5, middle - high / 2, max(right - left - 1, 1), high), _PLANTED)
        else:
            painter.setPen(QPen(DIM, 1, Qt.PenStyle.DotLine))
            painter.drawLine(QLineF(left, middle, right, middle))
    for frame in shown.pinned:
        _paint_pin(painter, QPointF(scale.middle_of(frame), band.top() + 2))
    for frame in shown.doubts:
        _paint_doubt(painter, QPointF(scale.middle_of(frame), band.center().y()))


def words_at(shown: FeetOverTime, found: FigureStances, frame: int) -> str:
    """Return what is said about a frame of the row."""
    stance = found.at(frame)
    planted = sum(foot.is_planted for foot in stance.feet)
    if stance.lift_px > 0:
        words = translate("FeetLane", "In the air, %1 px high").replace("%1", f"{stance.lift_px:.0f}")
    elif stance.feet:
        words = translate("FeetLane", "%1 of %2 feet planted").replace("%1", str(planted))
        words = words.replace("%2", str(len(stance.feet)))
    else:
        words = translate("FeetLane", "No foot seen")
    more = []
    begins = max((start for start in found.frames if start <= frame), default=1)
    if begins in shown.doubts:
        more.append(translate("FeetLane", "doubtful: please look whether this is right"))
    if begins in shown.pinned:
        more.append(translate("FeetLane", "pinned by hand"))
    return "\n".join((words, *more))


def _paint_pin(painter: QPainter, tip: QPointF) -> None:
    """Paint a pin: a small square on its corner."""
    painter.setPen(QPen(LINE, 1))
    painter.setBrush(SELECTED)
    arm = _MARK_PX * 0.75
    middle = tip + QPointF(0, arm)
    painter.drawPolygon(QPolygonF([middle + QPointF(x * arm, y * arm) for x, y in ((0, -1), (1, 0), (0, 1), (-1, 0))]))


def _paint_doubt(painter: QPainter, middle: QPointF) -> None:
    """Paint a warning: a triangle with a stroke, so that it is told by its shape, too."""
    arm = _MARK_PX + 1
    painter.setPen(QPen(LINE, 1))
    painter.setBrush(WARNING)
    corners = ((0.0, -1.0), (1.0, 0.8), (-1.0, 0.8))
    painter.drawPolygon(QPolygonF([middle + QPointF(x * arm, y * arm) for x, y in corners]))
    painter.setPen(QPen(BRIGHT, 1.4))
    painter.drawLine(QLineF(middle.x(), middle.y() - arm * 0.45, middle.x(), middle.y() + arm * 0.25))
