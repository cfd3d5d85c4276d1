"""The clipboard, as far as the window uses it: text that is copied and pasted."""

from typing import Protocol

from PySide6.QtGui import QGuiApplication


class Clipboard(Protocol):
    """Text that any window of the program, and any other program, may take."""

    def text(self) -> str:
        """Return what was copied last; empty where it is no text."""

    def put(self, text: str) -> None:
        """Copy text."""


class SystemClipboard:
    """The clipboard of the screen."""

    def text(self) -> str:
        """Return what was copied last; empty where it is no text."""
        return QGuiApplication.clipboard().text()

    def put(self, text: str) -> None:
        """Copy text."""
        QGuiApplication.clipboard().setText(text)
