"""A second way to hold Alt while dragging: window managers keep Alt-drags for moving windows."""

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QGuiApplication, QKeyEvent, QSinglePointEvent, QWindow
from PySide6.QtWidgets import QApplication

_ALT = Qt.KeyboardModifier.AltModifier
_POINTING = (
    QEvent.Type.MouseButtonPress, QEvent.Type.MouseMove, QEvent.Type.MouseButtonRelease,
    QEvent.Type.TabletPress, QEvent.Type.TabletMove, QEvent.Type.TabletRelease,
)  # fmt: skip


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
        assert isinstance(application, QApplication)
        application.installEventFilter(self)
        application.focusWindowChanged.connect(self._let_go)

    def finish(self) -> None:
        """Look at events no more, before the window goes."""
        application = QApplication.instance()
        if application is not None:
            application.removeEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Every event of the whole program comes by, thousands where a window is built: its class is known at once.
        if isinstance(event, QKeyEvent):
            return event.key() == Qt.Key.Key_A and self._take(event)
        if isinstance(event, QSinglePointEvent):
            self._point(event)
        return False

    def _point(self, event: QSinglePointEvent) -> None:
        """Have a hand that points hold Alt, and tell that a pen has left."""
        kind = event.type()
        if kind is QEvent.Type.TabletLeaveProximity:
            self.pen_left.emit()
        if self.is_held and kind in _POINTING:
            event.setModifiers(event.modifiers() | _ALT)

    def _let_go(self, _window: QWindow | None) -> None:
        """Hold the key no more: where it comes up in another program, nobody here sees it."""
        self.is_held = False

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
