"""What the window does with the files of layers: other drawings, drawings that are found again, and their folder."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QUrl, Signal
from PySide6.QtGui import QDesktopServices

from kagezou.document.model import Document
from kagezou.importing.new_cels import CharacterSource
from kagezou.importing.progress import Progress
from kagezou.importing.relinking import Relinked, found_again, missing_of, relinked
from kagezou.importing.retakes.retake import RetakeRead, read_retake, retaken
from kagezou.message import Message
from kagezou.ui.project.asking import Asking
from kagezou.ui.project.dialogs import Dialogs
from kagezou.ui.project.load import AnyLoad, Load
from kagezou.ui.project.loading import Loading
from kagezou.ui.system.bridge import Bridge


class LayerFiles(QObject):
    """Asks, loads beside the window, and changes the layer as one step.

    Parameters
    ----------
    bridge
        The session.
    dialogs
        Who asks.
    loading
        Where files are read beside the window.
    show
        Opens a folder as the system does.
    """

    noted = Signal(Message)
    changed = Signal(tuple)
    """The ids of layers that have other drawings now."""
    retaken = Signal(object)
    """The Report of a retake in which more than the place of the drawings changed."""

    def __init__(
        self,
        bridge: Bridge,
        dialogs: Dialogs,
        loading: Loading,
        show: Callable[[QUrl], object] = QDesktopServices.openUrl,
    ) -> None:
        super().__init__()
        self._bridge, self._dialogs, self._loading, self._show = bridge, dialogs, loading, show
        self._asking = Asking(loading, dialogs, loading.start)

    def replace(self) -> None:
        """Ask for other drawings of the layer worked on; its keys stay."""
        layer_id = self._bridge.layer_id
        if layer_id is not None and (paths := self._dialogs.pictures()):
            self._asking.pictures(paths, lambda sources: self._replacing(layer_id, sources))

    def relink(self) -> None:
        """Ask where missing drawings are: one folder mends all layers and the background; with none missing, say so."""
        ids = tuple(layer.id for layer in self._bridge.document.layers)
        missing = missing_of(self._bridge.document, ids, behind=True)
        if not missing:
            self.noted.emit(Message("no drawing is missing"))
        elif folder := self._dialogs.folder_of_cels():
            self._loading.start(self._relinking(ids, missing, folder))

    def show_folder(self) -> None:
        """Open the folder in which the drawings of the layer worked on lie."""
        layer_id = self._bridge.layer_id
        drawings = () if layer_id is None else self._bridge.document.layer(layer_id).cels.drawings
        folders = dict.fromkeys(drawing.path.parent for drawing in drawings)
        there = next((folder for folder in folders if folder.is_dir()), None)
        if there is not None:
            self._show(QUrl.fromLocalFile(str(there)))
        elif folders:
            self.noted.emit(Message("{path}: this folder is not there", path=str(next(iter(folders)))))

    def _replacing(self, layer_id: str, sources: tuple[CharacterSource, ...]) -> AnyLoad:
        document = self._bridge.document

        def read(progress: Progress) -> RetakeRead:
            return read_retake(document, layer_id, sources, progress)

        def put(read: RetakeRead) -> None:
            if any(layer.id == layer_id for layer in self._bridge.document.layers):
                done = retaken(self._bridge.document, layer_id, read)
                notes = done.notes_of_files if done.report.is_to_be_read else done.imported.notes
                self._edit(self.tr("Replace drawings"), done.imported.document, notes, (layer_id,))
                if done.report.is_to_be_read:
                    self.retaken.emit(done.report)

        return Load(sources[0].path.name, read, put)

    def _relinking(self, ids: tuple[str, ...], missing: tuple[Path, ...], folder: Path) -> AnyLoad:
        def read(progress: Progress) -> Relinked:
            return found_again(missing, folder, progress)

        def put(again: Relinked) -> None:
            document, notes = relinked(self._bridge.document, ids, again, behind=True)
            self._edit(self.tr("Relink drawings"), document, notes, ids)

        return Load(folder.name, read, put)

    def _edit(self, step: str, document: Document, notes: tuple[Message, ...], ids: tuple[str, ...]) -> None:
        self._bridge.session.edit(step, document)
        if self._bridge.document is document:
            for note in notes:
                self.noted.emit(note)
            self.changed.emit(ids)
