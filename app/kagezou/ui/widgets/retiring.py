"""Widgets that were replaced go for good as soon as nothing runs within them any more."""

from collections.abc import Iterable

from PySide6.QtCore import QCoreApplication, QEvent, QTimer
from PySide6.QtWidgets import QWidget


def retire(widgets: Iterable[QWidget]) -> None:
    """Hide widgets of one parent now and delete them when the event loop is next free.

    ``deleteLater`` alone waits for the loop of the very level it was called on: while a question stands or something
    loads, what is rebuilt again and again would pile up.
    """
    old = tuple(widgets)
    for widget in old:
        widget.hide()
    if old:
        QTimer.singleShot(0, old[0], lambda: _delete(old))


def _delete(old: Iterable[QWidget]) -> None:
    for widget in old:
        widget.deleteLater()
        QCoreApplication.sendPostedEvents(widget, QEvent.Type.DeferredDelete)
