"""Exporting to After Effects: everything into one folder, the script last."""

import time
from collections import Counter
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import Stopped, UsageProblem
from kagezou.export.after_effects.building import RenderedFootage, Written, hand_off
from kagezou.export.after_effects.controls import controlled, notes_on_controls
from kagezou.export.after_effects.drawings import CelFootage, remove_beyond
from kagezou.export.after_effects.labels import labelled
from kagezou.export.after_effects.mattes import MATTES
from kagezou.export.after_effects.renderings import Rendering, renderings_of
from kagezou.export.after_effects.script import script_of
from kagezou.export.after_effects.shown_drawings import BACKGROUND, Shown, notes_on_copies, shown_in, staying_in
from kagezou.export.after_effects.transforms import notes_on_transforms
from kagezou.export.checks import check_sources
from kagezou.export.file_kinds import BACKGROUNDS, DRAWINGS, MATTE_FRAMES, SCRIPT, FileCount, added_up
from kagezou.export.file_names import FileNames
from kagezou.export.frames import export_frames
from kagezou.export.made_files import BACKGROUND as BACKGROUND_FILE
from kagezou.export.made_files import DRAWING, MATTE, MadeFile, numbered_from
from kagezou.export.made_files import SCRIPT as SCRIPT_FILE
from kagezou.export.names import safe_names
from kagezou.export.planning import planned
from kagezou.export.request import Cancelled, ExportRequest, Missing, Progress, Summary
from kagezou.export.sequences import sequences_of
from kagezou.export.stand_ins import filled_throughout
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
    controls
        Whether the composition has a null whose sliders drive all shadows.
    format, depth, skip_existing, workers, missing
        As of `ExportRequest`.
    """

    folder: Path
    name: str
    per_drawing: bool = False
    copies: bool = True
    mattes: tuple[str, ...] = ()
    controls: bool = False
    format: str = "png"
    depth: int = 8
    skip_existing: bool = False
    workers: int = 2
    missing: Missing = Missing.FAIL

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
    counts
        The files by what they are: frames, copies and the script.
    made
        The same one by one.
    """

    script: Path | None
    exports: tuple[Summary, ...]
    notes: tuple[Message, ...]
    seconds: float
    counts: tuple[FileCount, ...]
    made: tuple[MadeFile, ...]


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
    filled = filled_throughout(document, request.missing)
    run = _ScriptRun(filled.document, replace(request, folder=request.folder.absolute()), progress, cancelled)
    summaries = tuple(run.export(each, open_context) for each in run.renderings)
    script: Path | None = None
    notes: tuple[Message, ...] = ()
    if not any(summary.cancelled for summary in summaries):
        with suppress(Stopped):
            script, notes = run.finish()
    counts, made = run.counts(summaries, script), run.made(summaries, script)
    return HandedOff(script, summaries, (*filled.notes, *notes), time.monotonic() - started, counts, made)


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
        plans = [planned(version, self._frames_of(each)) for each, version in self._versions.items()]
        self._drawings = shown_in(document, request.folder, request.workers)
        for drawings in self._drawings:
            drawings.check_place()
        for plan in plans:
            check_sources(plan.jobs)
        self._staying = staying_in(self._drawings, copies=request.copies)
        self._copying = tuple(each for each in self._drawings if each.owner not in self._staying)
        self._copied: Counter[Message] = Counter()
        self._copies_made: dict[str, CelFootage] = {}
        # The script is a step of its own, the last.
        self._all = sum(plan.files for plan in plans) + sum(each.count for each in self._copying) + 1
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

    def finish(self) -> tuple[Path, tuple[Message, ...]]:
        """Copy what is to be copied and write the script; return it, and what is to be said.

        Raises
        ------
        Stopped
            That was asked for meanwhile; there is no script then.
        """
        document, request = self._document, self._request
        cels = self._staying | self._copies()
        united = cut_groups(document, of_one_color=True)
        background = cels.pop(BACKGROUND, None)
        lit = "lit" in request.mattes
        written = Written(request.folder, self.footage, cels, background, lit, united)
        file = safe_names([request.name])[request.name] + ".jsx"
        made = labelled(document, hand_off(document, request.name, file, written))
        made = controlled(document, made) if request.controls else made
        write_bytes(request.folder / file, script_of(made).encode("ascii"))
        self._tell(self._all, self._all)
        copied = notes_on_copies(self._drawings, self._staying, copies=request.copies)
        notes = (*united.notes(), *copied, *notes_on_transforms(document), *notes_on_controls(made))
        return request.folder / file, notes

    def counts(self, summaries: tuple[Summary, ...], script: Path | None) -> tuple[FileCount, ...]:
        """Return how many files of each kind there are and should be."""
        drawn = [
            replace(count, kind=MATTE_FRAMES) if rendering.is_matte else count
            for rendering, summary in zip(self.renderings, summaries, strict=True)
            for count in summary.counts
        ]
        copies = [FileCount(_kind_of_copies(each), 0, each.count) for each in self._copying]
        copied = [FileCount(kind, count, 0) for kind, count in self._copied.items()]
        return added_up((*drawn, *copies, *copied, FileCount(SCRIPT, int(script is not None), 1)))

    def made(self, summaries: tuple[Summary, ...], script: Path | None) -> tuple[MadeFile, ...]:
        """Return the files that are there; of copies those of layers that are copied to the end."""
        frames = (
            replace(each, kind=MATTE) if rendering.is_matte else each
            for rendering, summary in zip(self.renderings, summaries, strict=True)
            for each in summary.made
        )
        copies = (
            MadeFile(path, BACKGROUND_FILE if owner == BACKGROUND else DRAWING, footage.first.parent.name, owner)
            for owner, footage in self._copies_made.items()
            for path in numbered_from(footage.first, footage.count)
        )
        return (*frames, *copies, *(() if script is None else (MadeFile(script, SCRIPT_FILE),)))

    def _copies(self) -> dict[str, CelFootage]:
        """Copy what cannot be taken from where it lies; raises Stopped between two files."""
        for each in self._copying:
            footage = each.copy(partial(self._copied_one, _kind_of_copies(each)))
            if footage is not None:
                self._copies_made[each.owner] = footage
        return dict(self._copies_made)

    def _copied_one(self, kind: Message) -> bool:
        """Take note of a copy; return whether to go on."""
        self._copied[kind] += 1
        self._tell(self._before + self._copied.total(), self._all)
        return not self._cancelled()

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
            names=FileNames(first=1),
        )

    def _note_footage(self, rendering: Rendering) -> None:
        """Keep what a rendering left in its folder, and remove what an earlier, longer one did."""
        document, request = self._versions[rendering], replace(self._frames_of(rendering), once=False)
        plan = planned(document, request) if self._request.per_drawing else None
        for sequence in filter(rendering.takes, sequences_of(document, request)):
            pictures = None if plan is None else plan.pictures_of(sequence)
            count = document.canvas.length_frames if pictures is None else max(pictures) + 1
            remove_beyond(sequence.name, count)
            self.footage[rendering, sequence.subject.owner] = RenderedFootage(sequence.file(1), count, pictures)


def _kind_of_copies(drawings: Shown) -> Message:
    return BACKGROUNDS if drawings.owner == BACKGROUND else DRAWINGS
