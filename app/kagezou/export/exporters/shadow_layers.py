"""Shadow layers: each shadow as numbered frames in a folder of its own."""

from typing import Final

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Option
from kagezou.export.exporters.importing_steps import after_effects_step, laying_step, sequence_step
from kagezou.export.exporters.numbered_frames import NumberedFrames, frames_request, sequence_lines
from kagezou.export.request import SUFFIXES, ExportRequest
from kagezou.message import Message


class ShadowLayers(NumberedFrames):
    """Shadows, each apart and those of a look as one, composites and mattes of receivers as frames."""

    __slots__ = ()

    def formats(self, _choices: ExportChoices) -> tuple[str, ...]:
        """Return every format of flat pictures."""
        return tuple(SUFFIXES)

    def is_layered(self, _choices: ExportChoices) -> bool:
        """Return False."""
        return False

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return its folders."""
        return sequence_lines(document, self.request(document, choices, place))

    def request(self, document: Document, choices: ExportChoices, place: Place) -> ExportRequest:
        """Return what the frames are asked for with."""
        return frames_request(document, choices, place.folder, is_layered=False)

    def next_steps(self, document: Document, choices: ExportChoices, _place: Place) -> tuple[Message, ...]:
        """Return how sequences are imported and laid."""
        form = choices.format
        return sequence_step(document, form), laying_step(document), after_effects_step(form)


SHADOW_LAYERS: Final = ShadowLayers(
    key="layers",
    label=Message("Shadow layers"),
    purpose=Message("numbered frames for any compositing program"),
    icon="target-frames",
    verb="render",
    options=frozenset(
        (
            Option.DEPTH,
            Option.UNITED,
            Option.COMPOSITE,
            Option.RECEIVERS,
            Option.ONLY_WORK_AREA,
            Option.NAMES,
            Option.SKIP_EXISTING,
            Option.MISSING,
        )
    ),
)
