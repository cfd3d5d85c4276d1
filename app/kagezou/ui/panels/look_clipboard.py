"""Looks on the clipboard: the text of a style, which any window of the program and any editor takes."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.style import style_of
from kagezou.io.clips.style_files import dumps_style, loads_style
from kagezou.ui.panels.style_use import put_on
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard


class LookClipboard(QObject):
    """Copies the look of the layer worked on, and puts a copied one on every layer that is chosen.

    Parameters
    ----------
    bridge
        The session.
    clipboard
        Where copies go.
    """

    refused = Signal(str)
    """One sentence on why nothing happened."""
    noted = Signal(str)
    """What there is to know of a look that was put on."""

    def __init__(self, bridge: Bridge, clipboard: Clipboard) -> None:
        super().__init__()
        self._bridge, self._clipboard = bridge, clipboard

    @property
    def can_paste(self) -> bool:
        """Whether there is a look on the clipboard."""
        return loads_style(self._clipboard.text()) is not None

    def copy(self) -> None:
        """Put the look of the layer worked on, as it is at the frame looked at, on the clipboard."""
        layer_id, document = self._bridge.layer_id, self._bridge.document
        if layer_id is not None:
            name = document.layer(layer_id).name[:80]
            self._clipboard.put(dumps_style(style_of(document, layer_id, self._bridge.frame, name)))

    def paste(self) -> None:
        """Put the look on the chosen layers as one step, lengths in the measure of each character."""
        style = loads_style(self._clipboard.text())
        if style is None:
            self.refused.emit(self.tr("There is no look on the clipboard; copy one from a layer first."))
            return
        if self._bridge.layer_ids:
            self.noted.emit(
                put_on(self._bridge, self._bridge.layer_ids, style, self.tr("Paste look"), with_light=False)
            )
