"""A second way to hold Alt while dragging: window managers keep Alt-drags for moving windows."""

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QSinglePointEvent
from PySide6.QtWidgets import QApplication

_ALT = Qt.KeyboardModifier.AltModifier
_KEYS = (QEvent.Type.KeyPress, QEvent.Type.KeyRelease, QEvent.Type.ShortcutOverride)
_POINTING = (
    QEvent.Type.MouseButtonPress, QEvent.Type.MouseMove, QEvent.Type.MouseButtonRelease,
    QEvent.Type.TabletPress, QEvent.Type.TabletMove, QEvent.Type.TabletRelease,
)  # fmt: skip
_WATCHED = (*_KEYS, *_POINTING, QEvent.Type.TabletLeaveProximity, QEvent.Type.WindowDeactivate)


class AltKey(QObject):
    """Lets the letter A stand for Alt: held when a drag begins, or pressed while it goes on.

    Only in widgets into which nobody types. Held, it repeats no command; tapped without a drag it is itself.
    """

    pen_left = Signal()
    """The pen was lifted far from the tablet, or is there no more; only the application is told."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.is_held = False
        application = QApplication.instance()
        assert application is not None
        application.installEventFilter(self)

    def finish(self) -> None:
        """Look at events no more, before the window goes."""
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        # Every event of the whole program comes by: thousands where a window is built.
        if kind not in _WATCHED:
            return False
        if kind is QEvent.Type.TabletLeaveProximity:
            self.pen_left.emit()
        if kind is QEvent.Type.WindowDeactivate:
            # Where the key comes up then, nobody here sees it.
            self.is_held = False
        if kind in _KEYS and isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_A:
            return self._take(event)
        if kind in _POINTING and self.is_held and isinstance(event, QSinglePointEvent):
            event.setModifiers(event.modifiers() | _ALT)
        return False

    def _take(self, event: QKeyEvent) -> bool:
        """Take note of the key, and keep it from everyone else while the hand drags."""
        if event.type() is QEvent.Type.KeyRelease:
            was_held, self.is_held = self.is_held and event.isAutoRepeat(), self.is_held and event.isAutoRepeat()
            return was_held
        focused = QApplication.focusWidget()
        types = focused is not None and focused.testAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled)
        if event.modifiers() & ~Qt.KeyboardModifier.ShiftModifier or types:
            return False
        self.is_held = True
        drags = bool(QGuiApplication.mouseButtons() & Qt.MouseButton.LeftButton)
        if drags and event.type() is QEvent.Type.ShortcutOverride:
            event.accept()
        return drags
