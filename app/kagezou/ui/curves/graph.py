"""The graph: curves and the playhead, drawn by pyqtgraph, and the places on it that the hand touches."""

from functools import partial

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QGraphicsItem, QGraphicsView, QLabel

from kagezou.tools.curves.graph_model import GraphModel
from kagezou.tools.curves.graph_pointer import GraphPointer
from kagezou.tools.curves.key_box import KeyBox
from kagezou.tools.curves.picture import CurvePicture, pictures_of
from kagezou.ui.curves.box_items import BoxItems
from kagezou.ui.curves.choice import Choice
from kagezou.ui.curves.curve_items import CurveItems
from kagezou.ui.curves.frame_axis import FrameAxis
from kagezou.ui.curves.graph_controller import GraphController, HandShown
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.shown_units import common_factor
from kagezou.ui.system.theme import BRIGHT, DIM, WELL
from kagezou.ui.system.window_keys import lies_on_command
from kagezou.ui.widgets.once_a_paint import OnceAPaint


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
        self.controller = GraphController(bridge, choice, lambda: self.model)
        self.controller.shown.connect(self._show_hand)
        self.controller.drag_ended.connect(self.refresh)
        self.drawn = CurveItems(self.getPlotItem())
        self._playhead = pg.InfiniteLine(angle=90, movable=False, pen=pg.mkPen(BRIGHT, width=1))
        self._box = pg.QtWidgets.QGraphicsRectItem()
        self._key_box = BoxItems(self.getPlotItem())
        self._said = QLabel(self)
        self._said.setObjectName("graph_words")
        self._said.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._said.hide()
        self._moves = OnceAPaint(self)
        self._made_of: tuple[object, ...] = ()
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

    @property
    def model(self) -> GraphModel:
        """What is seen now, and at which scale."""
        across, up = self.view.viewPixelSize()
        return GraphModel(self.pictures, (float(across), float(up)), self._choice.kind, self._choice.is_locked)

    @property
    def key_box(self) -> KeyBox | None:
        """The frame around the selected keys, where they can be pulled by it."""
        return self.model.key_box

    def refresh(self) -> None:
        """Draw everything anew."""
        state = self._bridge.session.state
        held = {(each.curve.address, each.curve.component): each.fitting for each in self.pictures}
        shown = self._choice.now
        # Of what is drawn in another way nothing can be used again.
        is_held = shown.normalises and self.controller.is_busy
        made_of = (shown.kind, shown.normalises, is_held, shown.ghost, state.document.canvas.length_frames)
        before = self.pictures if made_of == self._made_of else ()
        self._made_of = made_of
        self.pictures = pictures_of(state.document, shown, state.keys, held if self.controller.is_busy else {}, before)
        self.drawn.draw(state.document, shown.ghost, self.pictures)
        self._draw_key_box()
        self.getAxis("left").setScale(common_factor(each.curve.address.property for each in self.pictures))
        self.move_playhead()

    def move_playhead(self) -> None:
        """Draw the playhead where the session is."""
        self._playhead.setValue(self._bridge.frame)

    def fit_all(self) -> None:
        """Show the whole cut and every curve."""
        self._fit(self.pictures, (1.0, float(self._bridge.document.canvas.length_frames)))

    def fit_chosen(self) -> None:
        """Show the selected keys with their neighbourhood, or everything if none are selected."""
        frames = [mark.frame for picture in self.pictures for mark in picture.keys if mark.is_chosen]
        chosen = tuple(picture for picture in self.pictures if picture.chosen)
        if not frames:
            self.fit_all()
            return
        frames += [handle.frame for picture in chosen for handle in picture.handles]
        self._fit(chosen, (min(frames) - 3, max(frames) + 3))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        if event.button() is Qt.MouseButton.LeftButton and self._is_inside(event.position()):
            # The picture comes after the curves.
            self._bridge.let_pass(on=True, by_hand=True)
            self.controller.press(self._pointer(event), event.modifiers())
        elif event.button() is Qt.MouseButton.RightButton:
            self.menu_asked.emit(event.globalPosition().toPoint())
        else:
            super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.controller.is_down:
            self._moves.take(event, partial(_move, self, self._pointer(event)))
        else:
            super().mouseMoveEvent(event)
            self.setCursor(self.controller.hover(self._pointer(event)))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._moves.finish()
        if self._bridge.is_scrubbed:
            self._bridge.let_pass(on=False)
        if event.button() is Qt.MouseButton.LeftButton and self.controller.is_down:
            self.controller.release(self._pointer(event), event.modifiers())
        else:
            super().mouseReleaseEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.controller.double_click(self._pointer(event))
        else:
            super().mouseDoubleClickEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if not self.controller.key(event):
            # pyqtgraph takes arrows and letters for itself; the window's commands want them.
            event.ignore()

    def event(self, event: QEvent) -> bool:
        # The window's commands on these keys are for other parts; here they belong to the hand.
        if (
            event.type() is QEvent.Type.ShortcutOverride
            and isinstance(event, QKeyEvent)
            and self.controller.wants(event)
            and not lies_on_command(event, self)
        ):
            event.accept()
            return True
        return bool(super().event(event))

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.controller.leave()
        super().focusOutEvent(event)

    def _pointer(self, event: QMouseEvent) -> GraphPointer:
        place = self.view.mapSceneToView(self.mapToScene(event.position().toPoint()))
        keys, modifier = event.modifiers(), Qt.KeyboardModifier
        return GraphPointer(
            (place.x(), place.y()),
            (event.position().x(), event.position().y()),
            one_axis=bool(keys & modifier.ShiftModifier),
            alone=bool(keys & modifier.AltModifier),
            about_centre=bool(keys & modifier.ControlModifier),
        )

    def _show_hand(self, shown: HandShown) -> None:
        self._box.setVisible(shown.box is not None)
        if shown.box is not None:
            (left, low), (right, high) = shown.box
            self._box.setRect(QRectF(QPointF(left, low), QPointF(right, high)).normalized())
        self._said.setVisible(bool(shown.words))
        self._said.setText(shown.words)
        self._said.adjustSize()
        room = self.rect().bottomRight() - self._said.rect().bottomRight()
        place = QPointF(*shown.beside_px).toPoint() + QPoint(16, -self._said.height() - 10)
        self._said.move(min(max(place.x(), 0), room.x()), min(max(place.y(), 0), room.y()))

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
            # Its words and the grid took as long as a curve, with every painting.
            axis.setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)
        self.getAxis("left").setWidth(64)
        self.getPlotItem().addItem(self._playhead, ignoreBounds=True)
        self._box.setPen(pg.mkPen(BRIGHT, width=1, style=Qt.PenStyle.DashLine))
        self._box.setBrush(pg.mkBrush(255, 255, 255, 20))
        self._box.hide()
        self.getPlotItem().addItem(self._box, ignoreBounds=True)

    def _is_inside(self, point: QPointF) -> bool:
        return bool(self.view.sceneBoundingRect().contains(self.mapToScene(point.toPoint())))

    def _draw_key_box(self) -> None:
        self._key_box.show(self.key_box)

    def _fit(self, pictures: tuple[CurvePicture, ...], frames: tuple[float, float]) -> None:
        values = np.concatenate([_within(picture, frames) for picture in pictures] or [np.array([0.0, 1.0])])
        low, high = float(values.min()), float(values.max())
        room = max((high - low) * 0.12, abs(high) * 1e-3, 1e-3)
        self.view.setRange(xRange=(frames[0] - 0.5, frames[1] + 0.5), yRange=(low - room, high + room), padding=0.02)


def _move(graph: Graph, pointer: GraphPointer) -> None:
    graph.controller.move(pointer)
    # A scene tells its views by a call that waits which of its items changed: after the window has been painted, which
    # would be painted a second time for every move.
    QCoreApplication.sendPostedEvents(graph.scene(), QEvent.Type.MetaCall.value)


def _within(picture: CurvePicture, frames: tuple[float, float]) -> np.ndarray:
    seen = picture.line.values[(picture.line.frames >= frames[0]) & (picture.line.frames <= frames[1])]
    ends = [handle.ordinate for handle in picture.handles]
    return np.concatenate([seen if len(seen) else picture.line.values, np.array(ends)])
