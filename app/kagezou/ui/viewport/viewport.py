"""The viewport: the picture, the handles over it, and the events that reach them."""

from functools import partial

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, Signal
from PySide6.QtGui import (
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QResizeEvent,
    QTabletEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QMenu

from kagezou.io.images.cel_cache import CelCache
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.tools.handle import Cursor
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.contact_touch import ContactTouch
from kagezou.ui.viewport.foot_menu import open_foot_menu
from kagezou.ui.viewport.hand_keys import HandKeys
from kagezou.ui.viewport.handle_controller import HandleController
from kagezou.ui.viewport.overlay import Overlay
from kagezou.ui.viewport.pen import PenTaps
from kagezou.ui.viewport.picture_widget import PictureWidget
from kagezou.ui.viewport.pointer_report import Device, PointerReport, report_of
from kagezou.ui.viewport.viewpoint import Viewpoint
from kagezou.ui.widgets.once_a_paint import OnceAPaint
from kagezou.ui.widgets.picking import Picking
from kagezou.ui.widgets.space_bar import SpaceBar

_CURSORS = {
    Cursor.MOVE: Qt.CursorShape.SizeAllCursor,
    Cursor.HORIZONTAL: Qt.CursorShape.SizeHorCursor,
    Cursor.VERTICAL: Qt.CursorShape.SizeVerCursor,
    Cursor.ROTATE: Qt.CursorShape.CrossCursor,
}
_TABS: dict[int | None, int] = {Qt.Key.Key_Tab: 1, Qt.Key.Key_Backtab: -1}


class Viewport(PictureWidget):
    """Lets the hand work on the picture: passes mouse, pen, wheel and keys on to it and to the viewpoint.

    Parameters
    ----------
    bridge
        The session shown.
    cels, meshes
        Where decoded drawings and sets come from.
    space
        The space bar: held, it turns a drag into panning.
    """

    handle_menu_asked = Signal(object, QPoint)
    """A right click on a :class:`Handle`, at a place of the screen."""

    def __init__(self, bridge: Bridge, cels: CelCache, meshes: MeshCache, space: SpaceBar) -> None:
        super().__init__(bridge, cels, meshes, Viewpoint())
        self._space = space
        self._panned_from: QPointF | None = None
        self._taps = PenTaps()
        self._moves = OnceAPaint(self)
        self.foot_menu: QMenu | None = None
        self.controller = HandleController(bridge, self.viewpoint)
        self.keys = HandKeys(self, self.controller)
        self.contacts = ContactTouch(bridge, self.viewpoint, self.controller, cels)
        self.picking = Picking()
        self.overlay = Overlay(self, self.controller, self.viewpoint, self.picking)
        self.picking.changed.connect(self._show_cursor)
        bridge.session_replaced.connect(self.picking.give_up)
        self.setMouseTracking(True)
        self.setTabletTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled, False)
        self.setMinimumSize(160, 120)
        self.setAccessibleName(self.tr("Picture"))
        bridge.document_changed.connect(self.overlay.update)
        self.following.due.connect(self.overlay.update)
        bridge.selection_changed.connect(self.overlay.update)
        space.changed.connect(self._show_cursor)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.overlay.resize(self.size())

    def show_handles(self, *, shown: bool) -> None:
        """Show or hide everything over the picture."""
        self.overlay.shows_handles = shown
        self.overlay.update()

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QNativeGestureEvent) and _pinched(self.viewpoint, event):
            return True
        if isinstance(event, QKeyEvent) and event.type() is QEvent.Type.ShortcutOverride and self.keys.wants(event):
            event.accept()
            return True
        # Qt would take Tab for moving the focus; Escape gives the focus back to the window.
        pressed = event.key() if isinstance(event, QKeyEvent) and event.type() is QEvent.Type.KeyPress else None
        if pressed in _TABS and self.overlay.shows_handles:
            self.controller.cycle(_TABS[pressed])
            return True
        return super().event(event)

    def let_go(self) -> None:
        """End what the hand does, as it is: the pen or the window went away, and whatever lifts comes to others."""
        self._moves.finish()
        self._panned_from = None
        self.controller.release()
        self._show_cursor()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._moves.finish()
        report = report_of(event)
        match event.button():
            case Qt.MouseButton.MiddleButton:
                self._panned_from = event.position()
            case Qt.MouseButton.RightButton:
                self._ask_or_cancel(report, event.globalPosition().toPoint())
            case Qt.MouseButton.LeftButton if self._space.is_held:
                self._space.use()
                self._panned_from = event.position()
            case Qt.MouseButton.LeftButton if self.picking.is_on:
                self._pick(report)
            case Qt.MouseButton.LeftButton if self.overlay.shows_handles:
                self.controller.press(report)
        self._show_cursor()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._moves.take(event, partial(self._move, event.clone()))

    def _move(self, event: QMouseEvent) -> None:
        if self._panned_from is not None:
            way = event.position() - self._panned_from
            self._panned_from = event.position()
            self.viewpoint.pan(way.x(), way.y())
        elif self.controller.is_busy:
            # A move without the button comes from elsewhere, such as a window that just opened under the pointer.
            if event.buttons() & Qt.MouseButton.LeftButton:
                self.controller.move(report_of(event))
        elif self.overlay.shows_handles:
            self.controller.hover(None if self.picking.is_on else report_of(event))
        self._show_cursor()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._moves.finish()
        if event.button() in (Qt.MouseButton.MiddleButton, Qt.MouseButton.LeftButton):
            self._panned_from = None
        if event.button() is Qt.MouseButton.LeftButton:
            self.controller.release()
            self.controller.hover(None if self.picking.is_on else report_of(event))
        self._show_cursor()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        pointing = event.button() is Qt.MouseButton.LeftButton and not self._space.is_held and not self.picking.is_on
        if not (pointing and self.overlay.shows_handles and self.contacts.add(report_of(event))):
            self.mousePressEvent(event)

    def tabletEvent(self, event: QTabletEvent) -> None:
        report = report_of(event, Device.PEN)
        match event.type():
            case QEvent.Type.TabletPress if event.button() is Qt.MouseButton.RightButton:
                self._ask_or_cancel(report, event.globalPosition().toPoint())
            case QEvent.Type.TabletPress if self._space.is_held:
                self._space.use()
                self._panned_from = event.position()
            case QEvent.Type.TabletPress if self.picking.is_on:
                self._pick(report)
            case QEvent.Type.TabletPress:
                if not (self._taps.is_second_tap(report, event.timestamp()) and self.contacts.add(report)):
                    self.controller.press(report)
            case QEvent.Type.TabletMove if self._panned_from is not None:
                way = event.position() - self._panned_from
                self._panned_from = event.position()
                self.viewpoint.pan(way.x(), way.y())
            case QEvent.Type.TabletMove if self.controller.is_busy and not event.buttons():
                # It came back after it had gone in the middle of a drag.
                self.let_go()
            case QEvent.Type.TabletMove:
                self.controller.move(report) if self.controller.is_busy else self.controller.hover(
                    None if self.picking.is_on else report
                )
            case QEvent.Type.TabletRelease:
                self.let_go()
        event.accept()

    def wheelEvent(self, event: QWheelEvent) -> None:
        at, turned = event.position(), event.angleDelta()
        by_fingers = event.phase() is not Qt.ScrollPhase.NoScrollPhase and not event.pixelDelta().isNull()
        if by_fingers and not event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.viewpoint.pan(event.pixelDelta().x(), event.pixelDelta().y())
        else:
            # Qt turns the wheel's axis while Alt is held.
            self.viewpoint.zoom_at((at.x(), at.y()), (turned.y() or turned.x()) / 120)
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        self.controller.hover(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            if not self._cancel():
                self.clearFocus()
        elif not self.keys.press(event):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if not self.keys.release(event):
            super().keyReleaseEvent(event)

    def _ask_or_cancel(self, report: PointerReport, at: QPoint) -> None:
        """Open the menu of the foot or handle under the pointer; elsewhere the right button cancels."""
        can_ask = self.overlay.shows_handles and not self.controller.is_busy
        foot = self.contacts.foot_under(report) if can_ask else None
        handle = self.controller.under(report) if can_ask else None
        self.foot_menu = None if foot is None else open_foot_menu(self.contacts.contacts, foot, at, self)
        if foot is None and handle is not None and handle.addresses:
            self.controller.select(handle.id)
            self.handle_menu_asked.emit(handle, at)
        elif foot is None:
            self._cancel()

    def _cancel(self) -> bool:
        return self.picking.give_up() or self.controller.cancel()

    def _pick(self, report: PointerReport) -> None:
        self.picking.picked.emit(self.viewpoint.view.canvas_from_view(report.view_px))

    def _show_cursor(self) -> None:
        over = self.controller.held or self.controller.handles.find(self.controller.hovered_id)
        if self._panned_from is not None:
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif self._space.is_held:
            self.setCursor(Qt.CursorShape.OpenHandCursor)
        elif self.picking.is_on:
            self.setCursor(Qt.CursorShape.CrossCursor)
        else:
            on_piece = Qt.CursorShape.SizeAllCursor if self.controller.pieces.hovered_id else Qt.CursorShape.ArrowCursor
            self.setCursor(on_piece if over is None else _CURSORS[over.cursor])


def _pinched(viewpoint: Viewpoint, event: QNativeGestureEvent) -> bool:
    """Zoom as two fingers do; false where they do something else."""
    if event.gestureType() is not Qt.NativeGestureType.ZoomNativeGesture:
        return False
    at = event.position()
    viewpoint.magnify_at((at.x(), at.y()), 1.0 + event.value())
    return True
