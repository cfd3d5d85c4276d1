"""The real window with a project in it, to be touched and looked at by the scripts that picture it."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, QPointF, QRect, QSettings, Qt
from PySide6.QtGui import QImage, QMouseEvent
from PySide6.QtWidgets import QApplication, QDockWidget, QWidget

from kagezou.tools.handle import place_in_view
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.clipboard import SystemClipboard
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.main_window import MainWindow

_LEFT = Qt.MouseButton.LeftButton
_PATIENCE_S = 30.0


def spin(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
    """Let the window work for some time, or until something is so."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and not until():
        QApplication.processEvents()
        time.sleep(0.01)


class Pictured:
    """A window at whose handles a hand drags, and of whose parts pictures are taken."""

    def __init__(self, window: MainWindow) -> None:
        self.window = window
        self.parts = window.parts

    def go_to(self, frame: int, seconds: float = 0.4) -> None:
        """Show a frame, and wait for its picture."""
        self.parts.bridge.session.go_to(frame)
        spin(seconds)

    def open(self, project: Path, timeline_px: int) -> None:
        """Open a project, wait for its drawings and feet, and give the timeline a height."""
        self.parts.project.open_path(project)
        spin(_PATIENCE_S, lambda: bool(self.parts.bridge.document.layers))
        spin(_PATIENCE_S, lambda: not self.parts.feet.is_busy)
        timeline = self.parts.time.timeline
        docks = [each for each in self.window.findChildren(QDockWidget) if each.isAncestorOf(timeline)]
        self.window.resizeDocks(docks, [timeline_px], Qt.Orientation.Vertical)
        spin(1.0)

    def place(self, handle_id: str) -> QPoint:
        """Return where a handle is in the viewport, logical px."""
        viewport = self.parts.viewport
        handle = viewport.controller.handles.find(handle_id)
        if handle is None:
            raise SystemExit(f"no handle {handle_id}")
        (x, y), _ = place_in_view(handle, viewport.viewpoint.view, viewport.viewpoint.size)
        return QPoint(round(x), round(y))

    def press(self, place: QPoint) -> None:
        """Take hold of what is at a place of the viewport."""
        self._mouse(QEvent.Type.MouseMove, place, Qt.MouseButton.NoButton, Qt.MouseButton.NoButton)
        self._mouse(QEvent.Type.MouseButtonPress, place, _LEFT, _LEFT)

    def move(self, place: QPoint) -> None:
        """Drag to a place of the viewport."""
        self._mouse(QEvent.Type.MouseMove, place, Qt.MouseButton.NoButton, _LEFT)
        spin(0.15)

    def release(self, place: QPoint) -> None:
        """Let go."""
        self._mouse(QEvent.Type.MouseButtonRelease, place, _LEFT, Qt.MouseButton.NoButton)
        self.leave()

    def leave(self) -> None:
        """Take the pointer from the picture, and its words with it."""
        self._mouse(QEvent.Type.MouseMove, QPoint(3, 3), Qt.MouseButton.NoButton, Qt.MouseButton.NoButton)
        QApplication.sendEvent(self.parts.viewport, QEvent(QEvent.Type.Leave))
        spin(0.3)

    def picture(self, *widgets: QWidget) -> QImage:
        """Return the window as it is seen, or the part of it that some of its widgets take."""
        spin(0.3)
        whole = self.window.grab().toImage()
        if not widgets:
            return whole
        part = QRect()
        for each in widgets:
            part = part.united(QRect(each.mapTo(self.window, QPoint()), each.size()))
        return whole.copy(part.intersected(whole.rect()))

    def _mouse(self, kind: QEvent.Type, place: QPoint, button: Qt.MouseButton, held: Qt.MouseButton) -> None:
        viewport, where = self.parts.viewport, QPointF(place)
        event = QMouseEvent(kind, where, viewport.mapToGlobal(where), button, held, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(viewport, event)


@contextmanager
def opened(folder: Path, size: tuple[int, int]) -> Iterator[Pictured]:
    """Yield a window of a size with settings of its own; the folder is for these."""
    store = QSettings(str(folder / "settings.ini"), QSettings.Format.IniFormat)
    settings = Settings(store, folder / "styles", folder / "recovery", folder / "pictures")
    window = MainWindow(OpenProject(), settings, SystemClipboard())
    window.resize(*size)
    window.show()
    spin(1.0)
    try:
        yield Pictured(window)
    finally:
        window.close_unasked()
        spin(0.2)
