"""What becomes of files held over the window, said before they are let go."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt
from PySide6.QtWidgets import QLabel, QWidget

from kagezou.ui.project.dropped_files import PROJECT_SUFFIX, dropped_files_of

_MOST_LOOKED_AT = 12
"""Pictures are known by their first bytes; a few say what the others are."""


class DropHint(QLabel):
    """A sheet over a widget while files are held over the window.

    Parameters
    ----------
    under
        The widget it covers.
    """

    def __init__(self, under: QWidget) -> None:
        super().__init__(under)
        self.setObjectName("drop_hint")
        self.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.setWordWrap(True)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._under = under
        under.installEventFilter(self)
        self.hide()

    def show_words(self, words: str | None) -> None:
        """Say what will happen, or nothing any more."""
        self.setText(words or "")
        self.setVisible(words is not None)
        self.setGeometry(self._under.rect())
        self.raise_()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Resize:
            self.setGeometry(self._under.rect())
        return super().eventFilter(watched, event)


def drop_words(paths: Sequence[Path]) -> str:
    """Return what letting go of these files would do."""
    translate = QCoreApplication.translate
    dropped = dropped_files_of(paths[:_MOST_LOOKED_AT])
    first = paths[0].name
    if dropped.project is not None or paths[0].suffix.lower() == PROJECT_SUFFIX:
        return translate("DropHint", "Open %1").replace("%1", first)
    if dropped.set_file is not None:
        return translate("DropHint", "Put %1 behind the characters").replace("%1", dropped.set_file.name)
    if dropped.background is not None:
        return translate("DropHint", "Put %1 under everything").replace("%1", first)
    if len(paths) == 1:
        return translate("DropHint", "Bring in %1").replace("%1", first)
    words = translate("DropHint", "Bring in %1 and %2 more")
    return words.replace("%1", first).replace("%2", str(len(paths) - 1))
