"""Files that are held over a window and let go there, as a file manager has them."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import PySide6
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QWidget

_COPY, _PLAIN = Qt.DropAction.CopyAction, Qt.KeyboardModifier.NoModifier


def carried(paths: Iterable[Path]) -> QMimeData:
    """Return what is dragged of some files."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return data


def hold(
    widget: QWidget, data: QMimeData, place: QPointF, button: Qt.MouseButton = Qt.MouseButton.NoButton
) -> QDragEnterEvent:
    """Bring what is dragged over a widget, and return the event."""
    # Since 6.12 Qt takes parts of a pixel here, too, and its older way for deprecated.
    at: Any = place if PySide6.__version_info__[:2] >= (6, 12) else place.toPoint()
    enter = QDragEnterEvent(at, _COPY, data, button, _PLAIN)
    QApplication.sendEvent(widget, enter)
    return enter


def let_go(widget: QWidget, data: QMimeData, place: QPointF, button: Qt.MouseButton = Qt.MouseButton.NoButton) -> None:
    """Let go of what is dragged over a widget."""
    QApplication.sendEvent(widget, QDropEvent(place, _COPY, data, button, _PLAIN))
