"""Which exposures of a layer are chosen: a run of neighbours, by the frames on which they begin."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.exposure_edits import Exposures, index_at
from kagezou.ui.system.bridge import Bridge


class DrawingChoice(QObject):
    """The chosen exposures; keys and exposures are never chosen together.

    Parameters
    ----------
    bridge
        The session.
    """

    changed = Signal()

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._layer_id: str | None = None
        self._frames = (1, 1)
        bridge.keys_changed.connect(self._give_way)
        bridge.session_replaced.connect(self.clear)
        bridge.document_changed.connect(self._forget_gone)

    @property
    def layer_id(self) -> str | None:
        """Whose exposures are chosen; None if none are."""
        return self._layer_id

    @property
    def run(self) -> tuple[int, int] | None:
        """The indices of the first and last one that are chosen."""
        if self._layer_id is None:
            return None
        first, last = (index_at(self._exposures(self._layer_id), frame) for frame in self._frames)
        return None if last is None else (first or 0, last)

    def choose(self, layer_id: str, first: int, last: int | None = None) -> None:
        """Choose exposures by the frames on which the first and the last one begin, and work on their layer."""
        session = self._bridge.session
        if session.state.keys:
            session.select_keys(frozenset())
        if self._bridge.layer_id != layer_id:
            session.select(layer_id)
        self._layer_id, self._frames = layer_id, (first, first if last is None else last)
        self.changed.emit()

    def extend(self, layer_id: str, frame: int) -> None:
        """Choose everything from what is chosen to what begins on a frame."""
        if layer_id != self._layer_id:
            self.choose(layer_id, frame)
        else:
            self.choose(layer_id, min(self._frames[0], frame), max(self._frames[1], frame))

    def holds(self, layer_id: str, index: int) -> bool:
        """Return whether an exposure is chosen."""
        run = self.run if layer_id == self._layer_id else None
        return run is not None and run[0] <= index <= run[1]

    def clear(self) -> None:
        """Choose none."""
        if self._layer_id is not None:
            self._layer_id = None
            self.changed.emit()

    def _exposures(self, layer_id: str) -> Exposures:
        return self._bridge.document.layer(layer_id).cels.exposures

    def _give_way(self) -> None:
        if self._bridge.session.state.keys:
            self.clear()

    def _forget_gone(self) -> None:
        if self._layer_id not in {None, *(layer.id for layer in self._bridge.document.layers)}:
            self.clear()
