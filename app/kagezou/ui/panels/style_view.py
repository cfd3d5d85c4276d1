"""The pictures of the styles as a list that says which one is looked at: under the pointer, or come to by the keys."""

from PySide6.QtCore import QCoreApplication, QEvent, QModelIndex, QObject, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent
from PySide6.QtWidgets import QListView, QListWidget

LOOK_MS = 250
"""So long the pointer or the keys rest on a style before it is looked at; passing over shows nothing."""

_ICON_LETTERS = 10
_ENTER = (Qt.Key.Key_Return, Qt.Key.Key_Enter)
_ARROWS = (Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down)
_KEYS = (*_ENTER, *_ARROWS, Qt.Key.Key_Home, Qt.Key.Key_End)


class StyleView(QListWidget):
    """Pictures with names; a click or Enter chooses, resting on one looks at it, leaving or Escape looks away."""

    picked = Signal(int)
    """A row was clicked, or Enter pressed on it."""
    looked_at = Signal(int)
    looked_away = Signal()

    def __init__(self) -> None:
        super().__init__()
        letter = self.fontMetrics().horizontalAdvance("0")
        side = _ICON_LETTERS * letter
        self.setViewMode(QListView.ViewMode.IconMode)
        self.setResizeMode(QListView.ResizeMode.Adjust)
        self.setMovement(QListView.Movement.Static)
        self.setIconSize(QSize(side, side))
        self.setGridSize(QSize(side + 2 * letter, side + round(1.8 * self.fontMetrics().height())))
        self.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.setMouseTracking(True)
        self._pointed: int | None = None
        self._is_by_keys = False
        self._rest = QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(LOOK_MS)
        self._rest.timeout.connect(self._look)
        self.entered.connect(lambda index: self._point(index.row(), by_keys=False))
        self.viewportEntered.connect(self._leave)
        self.clicked.connect(self._pick)

    def look_away(self) -> None:
        """Look at no style any more."""
        self._rest.stop()
        if self._pointed is not None:
            self._pointed = None
            _application().removeEventFilter(self)
            self.looked_away.emit()

    def viewportEvent(self, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Leave:
            self._leave()
        return super().viewportEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        if self._is_by_keys:
            self.look_away()
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self.look_away()
        super().hideEvent(event)

    def event(self, event: QEvent) -> bool:
        # A key that goes through the list may lie on a command of the window.
        if isinstance(event, QKeyEvent) and event.type() is QEvent.Type.ShortcutOverride:
            plain = not event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
            if plain and event.key() in _KEYS:
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _ENTER:
            self._pick(self.currentIndex())
            return
        before = self.currentRow()
        super().keyPressEvent(event)
        if self.currentRow() not in (before, -1):
            self._point(self.currentRow(), by_keys=True)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # While something is looked at Escape looks away, wherever the keyboard is.
        if isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() is QEvent.Type.KeyPress:
                self.look_away()
            event.accept()
            return True
        return super().eventFilter(watched, event)

    def _leave(self) -> None:
        """Take note that the pointer is on no style; what the keys came to stays."""
        if not self._is_by_keys:
            self.look_away()

    def _point(self, row: int, *, by_keys: bool) -> None:
        self._pointed, self._is_by_keys = row, by_keys
        self._rest.start()

    def _look(self) -> None:
        if self._pointed is not None:
            _application().installEventFilter(self)
            self.looked_at.emit(self._pointed)

    def _pick(self, index: QModelIndex) -> None:
        self.look_away()
        if index.isValid():
            self.picked.emit(index.row())


def _application() -> QCoreApplication:
    application = QCoreApplication.instance()
    if application is None:
        raise RuntimeError("a widget without an application")
    return application
