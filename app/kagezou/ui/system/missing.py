"""Which drawings are not where the project says: looked for beside the window, again whenever one comes back to it."""

from collections.abc import Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType

from PySide6.QtCore import QObject, Qt, Signal

from kagezou.document.model import Cels
from kagezou.ui.system.background import Latest, Turn
from kagezou.ui.system.bridge import Bridge

Missing = Mapping[str, tuple[Path, ...]]
"""By the ids of layers: the files that are not there, each once; layers that miss none are left out."""

NOTHING_MISSING: Missing = MappingProxyType({})


class MissingDrawings(QObject):
    """Knows which files of layers are not there.

    Parameters
    ----------
    bridge
        The session.
    """

    changed = Signal()

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._cels: tuple[Cels, ...] = ()
        self._background = Latest[Missing](self._take, low_priority=True)
        self.files = NOTHING_MISSING
        bridge.document_changed.connect(self._follow)
        self.look_again()

    def look_again(self) -> None:
        """Look for all files anew: they may have come or gone meanwhile."""
        layers = self._bridge.document.layers
        self._cels = tuple(layer.cels for layer in layers)
        wanted = {layer.id: tuple(dict.fromkeys(each.path for each in layer.cels.drawings)) for layer in layers}
        self._background.ask(partial(_look, wanted))

    def come_back(self, state: Qt.ApplicationState) -> None:
        """Look again when the program is turned to."""
        if state is Qt.ApplicationState.ApplicationActive:
            self.look_again()

    def wait(self) -> None:
        """Wait until the looking is done; what was found is delivered later."""
        self._background.wait()

    def finish(self) -> None:
        """End what works beside the window."""
        self._background.finish()

    def _follow(self) -> None:
        cels = tuple(layer.cels for layer in self._bridge.document.layers)
        if len(cels) != len(self._cels) or any(a is not b for a, b in zip(cels, self._cels, strict=True)):
            self.look_again()

    def _take(self, missing: Missing) -> None:
        if missing != self.files:
            self.files = missing
            self.changed.emit()


def _look(wanted: Mapping[str, tuple[Path, ...]], turn: Turn[Missing]) -> None:
    found: dict[str, tuple[Path, ...]] = {}
    for layer_id, paths in wanted.items():
        if turn.is_unwanted:
            return
        lost = tuple(path for path in paths if not path.is_file())
        if lost:
            found[layer_id] = lost
    turn.tell(MappingProxyType(found))


def missing_words(paths: tuple[Path, ...], words: str) -> str:
    """Return a tool tip: words with the number of files for %1, and the first of them by name."""
    most = 8
    names = [path.name for path in paths[:most]]
    more = ["…"] if len(paths) > most else []
    return "\n".join([words.replace("%1", str(len(paths))), str(paths[0].parent), *names, *more])
