"""Exporting to After Effects: everything into one folder, the script last."""

import time
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.building import RenderedFootage, Written, hand_off
from kagezou.export.after_effects.drawings import remove_beyond
from kagezou.export.after_effects.mattes import MATTES
from kagezou.export.after_effects.renderings import Rendering, renderings_of
from kagezou.export.after_effects.script import script_of
from kagezou.export.after_effects.shown_drawings import BACKGROUND, footage_of, shown_in
from kagezou.export.after_effects.transforms import notes_on_transforms
from kagezou.export.frames import export_frames
from kagezou.export.names import safe_names
from kagezou.export.planning import planned
from kagezou.export.request import Cancelled, ExportRequest, Progress, Summary
from kagezou.export.sequences import sequences_of
from kagezou.export.uniting import cut_groups
from kagezou.io.files.atomic import write_bytes
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

_AE_LONGEST_S: Final = 10800
_AE_SIZES_PX: Final = (4, 30000)
_AE_RATES: Final = (1, 99)
FORMATS: Final = ("png", "exr")


@dataclass(frozen=True, slots=True)
class HandOffRequest:
    """What to hand off.

    Parameters
    ----------
    folder
        Where everything goes.
    name
        What the composition and the script are called.
    per_drawing
        Whether each different shadow is written once and held by time remapping, instead of a file for every frame.
    copies
        Whether characters and background are copied; else they are referred to where they lie, if that can be done.
    mattes
        Keys of `MATTES`.
    format, depth, skip_existing, workers
        As of `ExportRequest`.
    """

    folder: Path
    name: str
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    format: str = "png"
    depth: int = 8
    skip_existing: bool = False
    workers: int = 2

    def __post_init__(self) -> None:
        for matte in self.mattes:
            if matte not in MATTES:
                raise UsageProblem(
                    Message("there is no matte {matte!r}, only {mattes}", matte=matte, mattes=", ".join(MATTES))
                )
        if self.format not in FORMATS:
            raise UsageProblem(
                Message(
                    "shadows for After Effects are {formats}, not {format!r}",
                    formats=" or ".join(FORMATS),
                    format=self.format,
                )
            )


@dataclass(frozen=True, slots=True)
class HandedOff:
    """What came of it.

    Parameters
    ----------
    script
        The script; None if the export was stopped before everything it needs was there.
    exports
        What came of the sequences of shadows and mattes.
    notes
        What the user should know, one sentence each.
    """

    script: Path | None
    exports: tuple[Summary, ...]
    notes: tuple[Message, ...]
    seconds: float


def export_to_after_effects(
    document: Document, request: HandOffRequest, open_context: OpenContext, progress: Progress, cancelled: Cancelled
) -> HandedOff:
    """Write shadows, mattes, footage and, when all of it is there, the script that builds the composition.

    A second hand-off into the same folder brings it up to date, and the script then updates what it built before.

    Raises
    ------
    UsageProblem
        After Effects has no composition of such a size, rate or length, or there is nothing to make.
    InputProblem, DiskFullProblem, OutputProblem, GraphicsProblem
        As for `export_frames`.
    """
    started = time.monotonic()
    _check(document)
    request = replace(request, folder=request.folder.absolute())
    run = _ScriptRun(document, request, progress, cancelled)
    drawings = shown_in(document, request.folder, request.workers)
    for each in drawings:
        each.check_place()
    summaries = [run.export(each, open_context) for each in run.renderings]
    if any(summary.cancelled for summary in summaries):
        return HandedOff(None, tuple(summaries), (), time.monotonic() - started)
    united = cut_groups(document, of_one_color=True)
    cels, notes = footage_of(drawings, copies=request.copies)
    notes = (*united.notes(), *notes, *notes_on_transforms(document))
    lit, groups = "lit" in request.mattes, united.of_several()
    background = cels.pop(BACKGROUND, None)
    written = Written(request.folder, run.footage, cels, background, lit, groups)
    file = safe_names([request.name])[request.name] + ".jsx"
    text = script_of(hand_off(document, request.name, file, written))
    write_bytes(request.folder / file, text.encode("ascii"))
    return HandedOff(request.folder / file, tuple(summaries), notes, time.monotonic() - started)


def _check(document: Document) -> None:
    canvas = document.canvas
    low, high = _AE_SIZES_PX
    if not (low <= canvas.width_px <= high and low <= canvas.height_px <= high):
        raise UsageProblem(
            Message(
                "After Effects has no composition of {width_px}x{height_px} px",
                width_px=canvas.width_px,
                height_px=canvas.height_px,
            )
        )
    if not _AE_RATES[0] <= canvas.frame_rate <= _AE_RATES[1]:
        raise UsageProblem(
            Message("After Effects has no composition of {frame_rate} frames a second", frame_rate=canvas.frame_rate)
        )
    if canvas.length_frames / canvas.frame_rate > _AE_LONGEST_S:
        raise UsageProblem(
            Message("After Effects has no composition of {length_frames} frames", length_frames=canvas.length_frames)
        )


class _ScriptRun:
    """One hand-off under way."""

    def __init__(self, document: Document, request: HandOffRequest, progress: Progress, cancelled: Cancelled) -> None:
        self._document, self._request, self._cancelled = document, request, cancelled
        self._tell = progress
        self._before = 0
        self.renderings = renderings_of(document, request.mattes)
        self._versions = {each: each.version(document) for each in self.renderings}
        self._all = sum(planned(version, self._frames_of(each)).files for each, version in self._versions.items())
        self.footage: dict[tuple[Rendering, str], RenderedFootage] = {}

    def export(self, rendering: Rendering, open_context: OpenContext) -> Summary:
        """Render one version of the document."""
        summary = export_frames(
            self._versions[rendering],
            self._frames_of(rendering),
            open_context,
            lambda done, _all: self._tell(self._before + done, self._all),
            self._cancelled,
        )
        self._before += summary.files
        if not summary.cancelled:
            self._note_footage(rendering)
        return summary

    def _frames_of(self, rendering: Rendering) -> ExportRequest:
        request = self._request
        return ExportRequest(
            folder=request.folder / rendering.folder,
            format=request.format,
            depth=request.depth if request.format == "png" else 16,
            skip_existing=request.skip_existing,
            workers=request.workers,
            once=request.per_drawing,
            only=rendering.only,
        )

    def _note_footage(self, rendering: Rendering) -> None:
        """Keep what a rendering left in its folder, and remove what an earlier, longer one did."""
        document, request = self._versions[rendering], replace(self._frames_of(rendering), once=False)
        plan = planned(document, request) if self._request.per_drawing else None
        for sequence in filter(rendering.takes, sequences_of(document, request)):
            pictures = None if plan is None else plan.pictures_of(sequence)
            count = document.canvas.length_frames if pictures is None else max(pictures) + 1
            remove_beyond(sequence.folder, sequence.label, sequence.digits, count)
            self.footage[rendering, sequence.subject.owner] = RenderedFootage(sequence.file(1), count, pictures)
