"""What the commands on drawings do: to those chosen in the timeline, else to the one seen at the playhead."""

from PySide6.QtCore import QObject, Signal

from kagezou.document import exposure_edits
from kagezou.document.exposure_edits import ExposureClip, Exposures, index_at
from kagezou.document.model import Layer
from kagezou.io.clips.timeline_clips import dumps_drawings, loads_drawings
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.timeline.drawing_choice import DrawingChoice


class DrawingCommands(QObject):
    """Splitting, replacing, holding, copying and pasting exposures; each is one step with a name.

    Parameters
    ----------
    bridge
        The session.
    choice
        The exposures that are chosen.
    """

    refused = Signal(str)
    """One sentence on why nothing happened."""

    def __init__(self, bridge: Bridge, choice: DrawingChoice, clipboard: Clipboard) -> None:
        super().__init__()
        self._bridge, self._choice, self._clipboard = bridge, choice, clipboard

    @property
    def are_chosen(self) -> bool:
        """Whether exposures are chosen."""
        return self._choice.run is not None

    @property
    def has_copy(self) -> bool:
        """Whether there are exposures on the clipboard."""
        return self._clip is not None

    @property
    def layer(self) -> Layer | None:
        """Whose exposures the commands are about."""
        layer_id = self._choice.layer_id or self._bridge.layer_id
        return None if layer_id is None else self._bridge.document.layer(layer_id)

    def split(self) -> None:
        """Begin the drawing at the playhead anew there."""
        layer = self.layer
        if layer is not None:
            frame = self._bridge.frame
            self._edit(layer, self.tr("Split drawing"), exposure_edits.split(layer.cels.exposures, frame))
            self._choice.choose(layer.id, frame)

    def insert(self, drawing: int | None) -> None:
        """Expose a drawing, or nothing, from the playhead until the next exposure."""
        layer = self.layer
        if layer is not None:
            frame = self._bridge.frame
            self._edit(layer, self.tr("Insert drawing"), exposure_edits.expose(layer.cels.exposures, frame, drawing))
            self._choice.choose(layer.id, frame)

    def replace(self, drawing: int | None) -> None:
        """Expose another drawing, or nothing, in the place of the chosen ones."""
        found = self._run()
        if found is not None:
            layer, run = found
            name = self.tr("Empty cel") if drawing is None else self.tr("Replace drawing")
            self._edit(layer, name, exposure_edits.replace_drawings(layer.cels.exposures, *run, drawing))

    def empty(self) -> None:
        """Expose nothing."""
        self.replace(None)

    def remove(self) -> None:
        """Take the exposures away; the drawing before is held on."""
        found = self._run()
        if found is not None:
            layer, run = found
            self._edit(layer, self.tr("Remove drawing"), exposure_edits.remove(layer.cels.exposures, *run))
            self._choice.clear()

    def hold_longer(self, frames: int) -> None:
        """Hold the last of the exposures longer, or shorter; what follows moves along."""
        found = self._run()
        if found is None:
            return
        layer, (_, last) = found
        exposures = layer.cels.exposures
        if last + 1 < len(exposures):
            end = exposures[last + 1].frame + frames
            changed = exposure_edits.end_at(exposures, last, end, ripples=True)
            self._edit(layer, self.tr("Hold longer") if frames > 0 else self.tr("Hold shorter"), changed)
        else:
            self.refused.emit(self.tr("The last drawing holds to the end of the cut; drag its end to shorten it."))

    def expose_on(self, step: int) -> None:
        """Hold each chosen drawing for ``step`` frames; with one or none chosen, each of the layer's."""
        layer = self.layer
        if layer is None or not layer.cels.exposures:
            return
        run = self._choice.run
        first, last = run if run is not None and run[0] < run[1] else (0, len(layer.cels.exposures) - 1)
        changed = exposure_edits.on_steps(layer.cels.exposures, first, last, step)
        document = exposure_edits.with_exposures(self._bridge.document, layer.id, changed, last_held=step)
        self._bridge.session.edit(self.tr("Expose on %1s").replace("%1", str(step)), document)
        if run is not None:
            count = min(last - first, len(changed) - 1 - first)
            self._choice.choose(layer.id, changed[first].frame, changed[first + count].frame)

    def copy(self) -> None:
        """Put the exposures on the clipboard, for any window of the program."""
        found = self._run()
        if found is not None:
            layer, run = found
            clip = exposure_edits.copy(layer.cels, *run, self._bridge.document.canvas.length_frames)
            self._clipboard.put(dumps_drawings(clip))

    def paste(self) -> None:
        """Put the copied exposures down at the playhead, onto the layer worked on."""
        layer_id, clip = self._bridge.layer_id, self._clip
        if clip is None or layer_id is None:
            self.refused.emit(self.tr("No drawings were copied yet."))
            return
        layer, frame = self._bridge.document.layer(layer_id), self._bridge.frame
        pasted = exposure_edits.paste(layer.cels, clip, frame)
        self._edit(layer, self.tr("Paste drawings"), pasted)
        self._choice.choose(layer.id, frame, frame + clip.entries[-1][0])
        known = {drawing.name for drawing in layer.cels.drawings}
        missing = sorted({name for _, name in clip.entries if name is not None and name not in known})
        if missing:
            words = self.tr("%1 has no drawings of these names, and they stay empty: %2")
            self.refused.emit(words.replace("%1", layer.name).replace("%2", ", ".join(missing[:5])))

    @property
    def _clip(self) -> ExposureClip | None:
        return loads_drawings(self._clipboard.text())

    def _run(self) -> tuple[Layer, tuple[int, int]] | None:
        """Return the layer and the indices the commands are about; None where nothing is exposed."""
        layer = self.layer
        if layer is None:
            return None
        here = index_at(layer.cels.exposures, self._bridge.frame)
        run = self._choice.run or (None if here is None else (here, here))
        if run is None:
            self.refused.emit(self.tr("No drawing is exposed at the playhead."))
            return None
        return layer, run

    def _edit(self, layer: Layer, name: str, exposures: Exposures) -> None:
        document = exposure_edits.with_exposures(self._bridge.document, layer.id, exposures)
        self._bridge.session.edit(name, document)
