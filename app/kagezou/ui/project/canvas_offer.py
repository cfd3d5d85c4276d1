"""The bar that offers the size of a background which was just laid under a picture of other sides."""

from dataclasses import replace

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QSizePolicy, QToolButton, QWidget

from kagezou.document.cut_settings import CutSettings, with_settings
from kagezou.document.model import Document
from kagezou.document.refitting import Refit
from kagezou.picture_source import PictureSource
from kagezou.ui.project.canvas_sizes import MOST_PX
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.icons import icon


class CanvasOffer(QWidget):
    """Hidden until a background of other sides is laid under the picture; never changes anything by itself.

    Parameters
    ----------
    bridge
        The session.
    """

    settings_asked = Signal(int, int)
    """The settings of the cut shall be opened with this width and height."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self.setObjectName("set_bar")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self._bridge = bridge
        self._known = _pictures(bridge.document)
        self._was_blank = bridge.document.is_blank
        self._size_px = (0, 0)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self.use, self.more = QPushButton(), QPushButton(self.tr("Cut Settings…"))
        self.close_button = QToolButton()
        self._lay_out()
        self.hide()
        bridge.document_changed.connect(self._look)
        bridge.session_replaced.connect(self._forget)

    def _lay_out(self) -> None:
        for button in (self.use, self.more):
            button.setObjectName("small_button")
        self.use.setToolTip(self.tr("The picture gets the size of the background; drawings stay in the middle"))
        self.use.clicked.connect(self._use)
        self.more.setToolTip(self.tr("Choose what becomes of the drawings"))
        self.more.clicked.connect(lambda: self.settings_asked.emit(*self._size_px))
        self.close_button.setIcon(icon("close"))
        self.close_button.setToolTip(self.tr("Dismiss"))
        self.close_button.setAccessibleName(self.tr("Dismiss"))
        self.close_button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.close_button.clicked.connect(self.hide)
        row = QHBoxLayout(self)
        row.setContentsMargins(10, 5, 6, 5)
        row.setSpacing(8)
        row.addWidget(self.words, 1)
        for widget in (self.use, self.more, self.close_button):
            row.addWidget(widget)

    def _forget(self) -> None:
        self._known = _pictures(self._bridge.document)
        self._was_blank = self._bridge.document.is_blank
        self.hide()

    def _look(self) -> None:
        """Offer the size of pictures that were not there before, until the picture has it or they are gone."""
        document = self._bridge.document
        pictures, was_blank = _pictures(document), self._was_blank
        is_new = pictures != self._known
        self._known, self._was_blank = pictures, document.is_blank
        size_px = background_size(document)
        canvas = document.canvas
        if size_px is None or size_px == (canvas.width_px, canvas.height_px):
            self.hide()
        elif is_new and not was_blank and max(size_px) <= MOST_PX:
            self._offer(size_px)

    def _offer(self, size_px: tuple[int, int]) -> None:
        canvas = self._bridge.document.canvas
        self._size_px = size_px
        counts = {"%1": size_px[0], "%2": size_px[1], "%3": canvas.width_px, "%4": canvas.height_px}
        words = self.tr("The background has %1 × %2 px, the picture %3 × %4.")
        use = self.tr("Use %1 × %2")
        for place, count in counts.items():
            words, use = (text.replace(place, str(count)) for text in (words, use))
        self.words.setText(words)
        self.use.setText(use)
        self.show()

    def _use(self) -> None:
        document = self._bridge.document
        width, height = self._size_px
        canvas = replace(document.canvas, width_px=width, height_px=height)
        changed = with_settings(document, CutSettings(canvas, document.slate), Refit.CENTRE)
        self._bridge.session.edit(self.tr("Size of the background"), changed.document)
        self.hide()


def background_size(document: Document) -> tuple[int, int] | None:
    """Return the largest width and height of the background's pictures, px; None where no size is known."""
    sizes = [drawing.size_px for drawing in document.behind.drawings if drawing.size_px is not None]
    return (max(width for width, _ in sizes), max(height for _, height in sizes)) if sizes else None


def _pictures(document: Document) -> tuple[PictureSource, ...]:
    return tuple(drawing.source for drawing in document.behind.drawings)
