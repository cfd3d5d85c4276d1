"""The hand-off to After Effects: footage in folders, and one script that builds the composition."""

from collections.abc import Iterator
from typing import Final

from kagezou.document.model import Document
from kagezou.export.after_effects.drawings import exposed
from kagezou.export.after_effects.export import FORMATS, HandedOff, HandOffRequest, export_to_after_effects
from kagezou.export.after_effects.renderings import renderings_of
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Exporter, ExportOutcome, Option
from kagezou.export.exporters.numbered_frames import workers
from kagezou.export.made_files import MadeFile
from kagezou.export.names import safe_names
from kagezou.export.planning import planned
from kagezou.export.request import Cancelled, ExportRequest, Missing, Progress
from kagezou.export.sequences import sequences_of
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


class HandOffExporter(Exporter[HandOffRequest, HandedOff]):
    """Everything that After Effects needs of a cut."""

    __slots__ = ()

    def lacks(self) -> None:
        """Return nothing: After Effects may be on another machine."""

    def formats(self, _choices: ExportChoices) -> tuple[str, ...]:
        """Return the formats that the script imports."""
        return FORMATS

    def is_layered(self, _choices: ExportChoices) -> bool:
        """Return False."""
        return False

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return the script, the folders of shadows and mattes, and what is copied."""
        return (_script(place), *_rendered(document, choices, place), *_copied(document, choices))

    def request(self, _document: Document, choices: ExportChoices, place: Place) -> HandOffRequest:
        """Return what is to be handed off."""
        return HandOffRequest(
            folder=place.folder,
            name=place.name,
            per_drawing=choices.per_drawing,
            copies=choices.copies,
            mattes=choices.mattes,
            controls=choices.controls,
            format=choices.format,
            depth=choices.depth if choices.format == "png" else 8,
            skip_existing=choices.skip_existing,
            workers=workers(),
            missing=Missing(choices.missing),
        )

    def export(
        self,
        document: Document,
        request: HandOffRequest,
        open_context: OpenContext,
        progress: Progress,
        cancelled: Cancelled,
    ) -> HandedOff:
        """Write the footage and the script."""
        return export_to_after_effects(document, request, open_context, progress, cancelled)

    def outcome(self, made: HandedOff, place: Place) -> ExportOutcome:
        """Return what came of it; the script is what to look for."""
        written = sum(each.written for each in made.exports)
        copied = sum(each.there for each in made.counts) - sum(each.written + each.trusted for each in made.exports)
        return ExportOutcome(
            counts=made.counts,
            written=written + copied,
            cancelled=made.script is None,
            problem=None,
            where=made.script or place.folder,
            notes=made.notes,
        )

    def made_files(self, made: HandedOff) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""
        return made.made

    def next_steps(self, _document: Document, _choices: ExportChoices, place: Place) -> tuple[Message, ...]:
        """Return how the script is run, and what it does."""
        return (
            Message("In After Effects: File > Scripts > Run Script File…, and choose {script}.", script=_script(place)),
            Message("It builds the composition: frame rate, alpha, order, Multiply and opacity are set."),
            Message("After the next export run it again: it brings the composition up to date and keeps your changes."),
        )

    def steps_after(
        self, came: ExportOutcome, document: Document, choices: ExportChoices, place: Place
    ) -> tuple[Message, ...]:
        """Return what to do next; of a stopped hand-off also why there is no script."""
        steps = super().steps_after(came, document, choices, place)
        return steps if came.is_whole else (*steps, Message("The script is written last, when all it needs is there."))


def _script(place: Place) -> str:
    """Return the name of the script."""
    return f"{safe_names([place.name])[place.name]}.jsx"


def _rendered(document: Document, choices: ExportChoices, place: Place) -> Iterator[str]:
    """Yield the folders of what is rendered, with how many files each gets where that is known."""
    length = document.canvas.length_frames
    for rendering in renderings_of(document, choices.mattes):
        request = ExportRequest(place.folder, format=choices.format, depth=choices.depth, only=rendering.only)
        version = rendering.version(document)
        counts = (
            (sequence, "" if choices.per_drawing else f"{length} × ") for sequence in sequences_of(version, request)
        )
        if choices.per_drawing and not rendering.is_matte:
            plan = planned(version, request)
            counts = ((each, f"{max(plan.pictures_of(each)) + 1} × ") for each in plan.sequences)
        yield from (f"{rendering.folder}/{each.label}/  {count}{request.suffix}" for each, count in counts)


def _copied(document: Document, choices: ExportChoices) -> Iterator[str]:
    """Yield what is copied."""
    if not choices.copies:
        return
    names = safe_names(layer.name for layer in document.layers)
    for layer in document.layers:
        if count := len(exposed(layer.cels, document.canvas.length_frames)):
            yield f"characters/{names[layer.name]}/  {count} × .png"
    if count := len(exposed(document.behind, document.canvas.length_frames)):
        yield "background/background.png" if count == 1 else f"background/  {count} × .png"


HAND_OFF: Final = HandOffExporter(
    key="after effects",
    label=Message("After Effects"),
    purpose=Message("a script that builds the whole composition"),
    icon="target-script",
    verb="export-ae",
    options=frozenset(
        (
            Option.DEPTH,
            Option.PER_DRAWING,
            Option.COPIES,
            Option.MATTES,
            Option.CONTROLS,
            Option.SKIP_EXISTING,
            Option.MISSING,
        )
    ),
)
