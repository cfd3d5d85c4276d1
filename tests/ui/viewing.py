"""Looking at the viewport and touching it, for the tests."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from kagezou.tools.handle import place_in_view
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.window.main_window import MainWindow


class OwnClipboard:
    """Text that is copied and pasted; the screen's own clipboard belongs to every program that runs there."""

    def __init__(self) -> None:
        self._text = ""

    def text(self) -> str:
        return self._text

    def put(self, text: str) -> None:
        self._text = text


def move(
    widget: QWidget,
    place: QPoint | QPointF,
    held: Qt.MouseButton = Qt.MouseButton.NoButton,
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
) -> None:
    """Move the pointer on a widget at once, with what is held meanwhile.

    QTest's own way carries neither button nor modifiers, and moves the screen's pointer, whose events come when they
    come, and not at all where it was already.
    """
    where = QPointF(place)
    event = QMouseEvent(
        QEvent.Type.MouseMove, where, widget.mapToGlobal(where), Qt.MouseButton.NoButton, held, modifiers
    )
    QApplication.sendEvent(widget, event)


def place_of(viewport: Viewport, handle_id: str) -> QPoint:
    handle = viewport.controller.handles.find(handle_id)
    assert handle is not None, f"no handle {handle_id}"
    (x, y), _ = place_in_view(handle, viewport.viewpoint.view, viewport.viewpoint.size)
    return QPoint(round(x), round(y))


def picture(viewport: Viewport) -> NDArray[np.uint8]:
    """The picture the renderer drew last, after everything that waits to be painted."""
    QApplication.processEvents()
    viewport.grab()
    pixels = viewport.read_picture()
    assert pixels is not None
    return np.asarray(pixels, np.uint8)


def drag(qtbot: QtBot, viewport: Viewport, handle_id: str, way: QPoint, *, let_go: bool = True) -> None:
    start = place_of(viewport, handle_id)
    move(viewport, start)
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=start)
    assert viewport.controller.held is not None, f"{handle_id} cannot be taken hold of"
    assert viewport.controller.held.id == handle_id
    for part in (1, 2, 3):
        move(viewport, start + QPoint(way.x() * part // 3, way.y() * part // 3), Qt.MouseButton.LeftButton)
    if let_go:
        qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=start + way)


def shadow_is_on_canvas(window: MainWindow) -> bool:
    """Whether something darker than the paper is seen, and none of it touches the canvas' edge but the ground."""
    grey = picture(window.parts.viewport)[..., :3].min(axis=2)
    dark = grey < 200
    edges = np.concatenate([dark[0], dark[:, 0], dark[:, -1], dark[-1]])
    return bool(dark.any() and not edges.any())


def write_garbage(path: Path) -> None:
    path.write_bytes(b"\x89PNG\r\n\x1a\n this is no picture")
