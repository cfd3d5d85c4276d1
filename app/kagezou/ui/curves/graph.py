"""The graph: curves, keys, handles, ghosts and the playhead, drawn by pyqtgraph."""

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QGraphicsView, QLabel

from kagezou.document.model import Document
from kagezou.ui.curves.choice import Choice, GraphKind
from kagezou.ui.curves.frame_axis import FrameAxis
from kagezou.ui.curves.graph_hand import GraphController
from kagezou.ui.curves.key_box import BoxItems, KeyBox, box_around
from kagezou.ui.curves.key_symbols import SYMBOLS
from kagezou.ui.curves.picture import CurvePicture, differing_frames, pictures_of, runs
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.theme import BRIGHT, CHANGED, DIM, SELECTED, WARNING, WELL

_KEY_PX = 11
_HANDLE_PX = 7
_DASHES = (None, [7, 4], [2, 4], [9, 3, 2, 3])
_GHOST_DASH = [4, 4]


class Graph(pg.PlotWidget):
    """Draws what the choice shows; the left button belongs to :class:`GraphController`.

    Parameters
    ----------
    bridge
        The session.
    choice
        What is shown.
    """

    menu_asked = Signal(object)

    def __init__(self, bridge: Bridge, choice: Choice) -> None:
        super().__init__(background=WELL, axisItems={"bottom": FrameAxis(bridge)})
        self._bridge, self._choice = bridge, choice
        self.pictures: tuple[CurvePicture, ...] = ()
        self.hand = GraphController(bridge, choice, self)
        self._drawn: list[pg.GraphicsObject] = []
        self._playhead = pg.InfiniteLine(angle=90, movable=False, pen=pg.mkPen(BRIGHT, width=1))
        self._box = pg.QtWidgets.QGraphicsRectItem()
        self._key_box = BoxItems(self.getPlotItem())
        self._said = QLabel(self)
        self._said.setObjectName("graph_words")
        self._said.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._said.hide()
        self._make_stage()
        self.view.sigRangeChanged.connect(self._draw_key_box)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled, on=False)
        # Lines of one device pixel leave trails at fractional scales otherwise.
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.FullViewportUpdate)
        self.setAccessibleName(self.tr("Curves over time"))
        self.refresh()
        self.fit_all()

    @property
    def view(self) -> pg.ViewBox:
        """The box with the graph's coordinates."""
        box = self.getPlotItem().getViewBox()
        assert isinstance(box, pg.ViewBox)
        return box

    def refresh(self) -> None:
        """Draw everything anew."""
        for item in self._drawn:
            self.getPlotItem().removeItem(item)
        self._drawn.clear()
        state = self._bridge.session.state
        held = {(each.curve.address, each.curve.component): each.fitting for each in self.pictures}
        self.pictures = pictures_of(state.document, self._choice, state.keys, held if self.hand.is_busy else {})
        self._draw_differences(state.document)
        self._draw_marks(state.document)
        for picture in self.pictures:
            self._draw_curve(picture)
        for picture in self.pictures:
            self._draw_keys(picture)
        self._draw_key_box()
        self.move_playhead()

    def move_playhead(self) -> None:
        """Draw the playhead where the session is."""
        self._playhead.setValue(self._bridge.frame)

    def show_box(self, box: QRectF | None) -> None:
        """Show the box that is drawn around keys, in graph coordinates."""
        self._box.setVisible(box is not None)
        if box is not None:
            self._box.setRect(box)

    @property
    def key_box(self) -> KeyBox | None:
        """The frame around the selected keys, where they can be pulled by it."""
        if self._choice.is_locked or self._choice.kind is GraphKind.SPEED:
            return None
        return box_around(self.pictures, self.pixels())

    def show_words(self, words: str, point: QPointF) -> None:
        """Show words beside a point of the widget; none take them away."""
        self._said.setVisible(bool(words))
        self._said.setText(words)
        self._said.adjustSize()
        room = self.rect().bottomRight() - self._said.rect().bottomRight()
        place = point.toPoint() + QPoint(16, -self._said.height() - 10)
        self._said.move(min(max(place.x(), 0), room.x()), min(max(place.y(), 0), room.y()))

    def fit_all(self) -> None:
        """Show the whole cut and every curve."""
        self._fit(self.pictures, (1.0, float(self._bridge.document.canvas.length_frames)))

    def fit_chosen(self) -> None:
        """Show the selected keys with their neighbourhood, or everything if none are selected."""
        frames = [mark.frame for picture in self.pictures for mark in picture.keys if mark.is_chosen]
        chosen = tuple(picture for picture in self.pictures if any(mark.is_chosen for mark in picture.keys))
        if not frames:
            self.fit_all()
            return
        frames += [handle.frame for picture in chosen for handle in picture.handles]
        self._fit(chosen, (min(frames) - 3, max(frames) + 3))

    def place_of(self, point: QPointF) -> tuple[float, float]:
        """Return the graph coordinates of a point of the widget."""
        place = self.view.mapSceneToView(self.mapToScene(point.toPoint()))
        return place.x(), place.y()

    def pixels(self) -> tuple[float, float]:
        """Return how many frames and units a pixel is."""
        across, up = self.view.viewPixelSize()
        return float(across), float(up)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() is Qt.MouseButton.LeftButton and self._is_inside(event.position()):
            self.hand.press(event)
        elif event.button() is Qt.MouseButton.RightButton:
            self.menu_asked.emit(event.globalPosition().toPoint())
        else:
            super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.hand.is_down:
            self.hand.move(event)
        else:
            super().mouseMoveEvent(event)
            self.hand.hover(event.position())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton and self.hand.is_down:
            self.hand.release(event)
        else:
            super().mouseReleaseEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.hand.double_click(event)
        else:
            super().mouseDoubleClickEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not self.hand.key(event):
            # pyqtgraph takes arrows and letters for itself; the window's commands want them.
            event.ignore()

    def event(self, event: QEvent) -> bool:
        # The window's commands on these keys are for other parts; here they belong to the hand.
        if event.type() is QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent) and self.hand.wants(event):
            event.accept()
            return True
        return bool(super().event(event))

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.hand.leave()
        super().focusOutEvent(event)

    def _make_stage(self) -> None:
        self.setMenuEnabled(False)
        self.hideButtons()
        self.showGrid(x=True, y=True, alpha=0.16)
        self.view.setMouseMode(pg.ViewBox.PanMode)
        for name in ("left", "bottom"):
            axis = self.getAxis(name)
            axis.setPen(pg.mkPen("#4c4c4c"))
            axis.setTextPen(pg.mkPen(DIM))
            axis.enableAutoSIPrefix(False)
        self.getAxis("left").setWidth(64)
        self.getPlotItem().addItem(self._playhead, ignoreBounds=True)
        self._box.setPen(pg.mkPen(BRIGHT, width=1, style=Qt.PenStyle.DashLine))
        self._box.setBrush(pg.mkBrush(255, 255, 255, 20))
        self._box.hide()
        self.getPlotItem().addItem(self._box, ignoreBounds=True)

    def _is_inside(self, point: QPointF) -> bool:
        return bool(self.view.sceneBoundingRect().contains(self.mapToScene(point.toPoint())))

    def _put(self, item: pg.GraphicsObject) -> None:
        self.getPlotItem().addItem(item, ignoreBounds=True)
        self._drawn.append(item)

    def _draw_key_box(self) -> None:
        self._key_box.show(self.key_box)

    def _draw_curve(self, picture: CurvePicture) -> None:
        curve = picture.curve
        if picture.ghost is not None:
            pen = pg.mkPen(QColor(curve.color).darker(130), width=1, dash=_GHOST_DASH)
            self._put(pg.PlotCurveItem(picture.ghost.frames, picture.ghost.values, pen=pen))
        hot = any(mark.is_chosen for mark in picture.keys)
        # Several curves of one colour's neighbourhood are told apart by their dashes.
        dash = _DASHES[curve.component % len(_DASHES)]
        pen = pg.mkPen(curve.color, width=2 if hot else 1, **({"dash": dash} if dash else {}))
        self._put(pg.PlotCurveItem(picture.line.frames, picture.line.values, pen=pen, antialias=True))
        if curve.name and len(picture.line.frames):
            label = pg.TextItem(curve.name, color=curve.color, anchor=(0, 0.5))
            label.setPos(picture.line.frames[-1], picture.line.values[-1])
            self._put(label)

    def _draw_keys(self, picture: CurvePicture) -> None:
        for handle in picture.handles:
            pen = pg.mkPen(SELECTED, width=1)
            ends = np.array([handle.key.frame, handle.frame]), np.array([handle.key.ordinate, handle.ordinate])
            self._put(pg.PlotCurveItem(*ends, pen=pen))
        spots = [
            {
                "pos": (mark.frame, mark.ordinate),
                "symbol": SYMBOLS[mark.interpolation],
                "brush": pg.mkBrush(SELECTED if mark.is_chosen else WELL),
                "pen": pg.mkPen(SELECTED if mark.is_chosen else picture.curve.color, width=1.5),
                "size": _KEY_PX,
            }
            for mark in picture.keys
        ]
        spots += [
            {
                "pos": (handle.frame, handle.ordinate),
                "symbol": "o",
                "brush": pg.mkBrush(SELECTED),
                "pen": pg.mkPen("#101010", width=1),
                "size": _HANDLE_PX,
            }
            for handle in picture.handles
        ]
        self._put(pg.ScatterPlotItem(spots))

    def _draw_differences(self, document: Document) -> None:
        if self._choice.ghost is None:
            return
        frames = sorted(
            {
                frame
                for picture in self.pictures
                for frame in differing_frames(document, self._choice.ghost, picture.curve)
            }
        )
        for first, last in runs(frames):
            color = QColor(WARNING)
            color.setAlpha(30)
            band = pg.LinearRegionItem((first - 0.5, last + 0.5), movable=False, brush=color, pen=pg.mkPen(None))
            band.setZValue(-20)
            self._put(band)

    def _draw_marks(self, document: Document) -> None:
        first, last = document.played
        for frame in (first, last) if document.work_area else ():
            self._put(pg.InfiniteLine(frame, angle=90, pen=pg.mkPen("#9a7a35", width=1)))
        for marker in document.markers:
            pen = pg.mkPen(CHANGED, width=1, style=Qt.PenStyle.DotLine)
            label = {"position": 0.96, "color": CHANGED, "movable": False}
            self._put(pg.InfiniteLine(marker.frame, angle=90, pen=pen, label=marker.comment or None, labelOpts=label))
        shown = {(each.curve.address.property.name, each.curve.address.layer_id) for each in self.pictures}
        for note in document.notes:
            if (note.property, note.layer_id) in shown:
                pen = pg.mkPen(WARNING, width=1, style=Qt.PenStyle.DashLine)
                label = {"position": 0.06, "color": WARNING, "movable": False}
                self._put(pg.InfiniteLine(note.frame, angle=90, pen=pen, label="✎", labelOpts=label))

    def _fit(self, pictures: tuple[CurvePicture, ...], frames: tuple[float, float]) -> None:
        values = np.concatenate([_within(picture, frames) for picture in pictures] or [np.array([0.0, 1.0])])
        low, high = float(values.min()), float(values.max())
        room = max((high - low) * 0.12, abs(high) * 1e-3, 1e-3)
        self.view.setRange(xRange=(frames[0] - 0.5, frames[1] + 0.5), yRange=(low - room, high + room), padding=0.02)


def _within(picture: CurvePicture, frames: tuple[float, float]) -> np.ndarray:
    seen = picture.line.values[(picture.line.frames >= frames[0]) & (picture.line.frames <= frames[1])]
    ends = [handle.ordinate for handle in picture.handles]
    return np.concatenate([seen if len(seen) else picture.line.values, np.array(ends)])
