"""Layered frames: each frame as one file that holds background, shadows and characters as layers."""

from typing import Final

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Option
from kagezou.export.exporters.numbered_frames import NumberedFrames, frames_request, sequence_lines
from kagezou.export.request import LAYERED_SUFFIXES, ExportRequest
from kagezou.export.selection import chosen_frames
from kagezou.export.sequences import layered_subject
from kagezou.message import Message
from kagezou.scene.evaluate import evaluate


class LayeredFrames(NumberedFrames):
    """Frames of layers."""

    __slots__ = ()

    def formats(self, _choices: ExportChoices) -> tuple[str, ...]:
        """Return every format of pictures with layers."""
        return tuple(LAYERED_SUFFIXES)

    def is_layered(self, _choices: ExportChoices) -> bool:
        """Return True."""
        return True

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return the folder and what is in its files, the uppermost layer first, as lists of layers have it."""
        request = self.request(document, choices, place)
        lines = sequence_lines(document, request)
        # The layers are the same in every frame.
        frame = chosen_frames(document, request)[0]
        content = layered_subject(document, request).content_at(document, evaluate(document, frame), frame)
        named = zip(content.group_names, content.part_names, strict=True)
        parts = [f"    {group} / {name}" if group else f"    {name}" for group, name in named]
        return (*lines, *reversed(parts))

    def request(self, document: Document, choices: ExportChoices, place: Place) -> ExportRequest:
        """Return what the frames are asked for with."""
        return frames_request(document, choices, place.folder, is_layered=True)

    def next_steps(self, _document: Document, choices: ExportChoices, _place: Place) -> tuple[Message, ...]:
        """Return what opens the files, and what of their layers is kept."""
        if choices.format == "exr":
            return (
                Message("Each file is one frame with a part for each layer, linear and with premultiplied alpha."),
                Message("Nuke, Natron and Blender read the parts as layers."),
                Message(
                    "The blend mode of each is its attribute kagezou:blend; laid in sRGB, not in linear light, "
                    "they make the picture."
                ),
            )
        return (
            Message("Each file is one frame; Photoshop and Clip Studio Paint open it with its layers."),
            Message("Opacity and blend mode of every layer are kept: nothing has to be set."),
            Message(
                "In After Effects: File > Import > File…; one file as “Composition” has the layers, "
                "a “Photoshop Sequence” is the finished picture."
            ),
        )


LAYERED_FRAMES: Final = LayeredFrames(
    key="layered",
    label=Message("Layered frames"),
    purpose=Message("one PSD or EXR a frame with all layers, to paint on"),
    icon="target-layered",
    verb="render",
    options=frozenset((Option.DEPTH, Option.ONLY_WORK_AREA, Option.NAMES, Option.SKIP_EXISTING, Option.MISSING)),
)
