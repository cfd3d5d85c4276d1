"""What the waves of a layer will do: whether they tear the outline, and a way to make them loop."""

from PySide6.QtWidgets import QLabel, QPushButton, QVBoxLayout, QWidget

from kagezou.document.wave_edits import WAVE_SETS, has_waves, loop_waves, wave_of
from kagezou.geometry.waves import tear_of
from kagezou.ui.system.bridge import Bridge


class WaveNote(QWidget):
    """The foot of the section of waves.

    Parameters
    ----------
    bridge
        The session.
    layer_ids
        Whose waves they are; what is said is about the first.
    """

    def __init__(self, bridge: Bridge, layer_ids: tuple[str, ...]) -> None:
        super().__init__()
        self._bridge = bridge
        self._layer_ids = layer_ids
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setToolTip(
            self.tr("Tear: 2π / length × the movement across the crests, added up over both sets; from 1 on it tears.")
        )
        self.loop = QPushButton(self.tr("Loop over the cut"))
        self.loop.setObjectName("small_button")
        self.loop.setToolTip(self.tr("Set both speeds to the nearest at which the last frame leads into the first"))
        self.loop.clicked.connect(self.snap_to_loop)
        column = QVBoxLayout(self)
        column.setContentsMargins(26, 2, 8, 6)
        column.setSpacing(4)
        column.addWidget(self.words)
        column.addWidget(self.loop)

    def refresh(self) -> None:
        """Show what is set at the frame looked at."""
        tracks = self._bridge.document.layer(self._layer_ids[0]).tracks
        waves = tuple(wave_of(tracks, lines, self._bridge.frame) for lines in WAVE_SETS)
        tear = tear_of(waves)
        if all(wave.reach_px == 0 for wave in waves):
            said = self.tr("No waves")
        elif tear < 1:
            said = self.tr("Tear %1: the outline wobbles")
        else:
            said = self.tr("Tear %1: the outline is torn into stripes")
        self.words.setText(said.replace("%1", f"{tear:.2f}"))
        self.loop.setEnabled(has_waves(tracks, self._bridge.frame))

    def snap_to_loop(self) -> None:
        """Make the waves come back after the cut, as one step; keyed speeds become constant."""
        document = loop_waves(self._bridge.document, self._layer_ids, self._bridge.frame)
        self._bridge.session.edit(self.tr("Loop waves"), document)
