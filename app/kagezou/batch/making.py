"""One cut from its files to project, output and record."""

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.batch.cut import Cut
from kagezou.batch.inputs import folders_of, made_of
from kagezou.batch.orders import EXPORTS, Orders
from kagezou.batch.pictures import doubtful_frames, thumbnails
from kagezou.batch.record import CutRecord, State, kept, read_record, write_record
from kagezou.document.model import Document
from kagezou.document.styling import put_style
from kagezou.errors import Problem, SomeFramesFailed
from kagezou.export.after.hooks import hand_on, hooks_of
from kagezou.export.after.manifest import Handover
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import ExportOutcome
from kagezou.export.request import Cancelled, ExportRequest, Progress
from kagezou.importing.cut_files import cut_files, document_of_cut
from kagezou.importing.feet import document_with_feet, doubt_notes
from kagezou.importing.imported import Imported
from kagezou.importing.new_cut import with_parts
from kagezou.importing.progress import Cancelled as LoadCancelled
from kagezou.importing.progress import LoadPhase
from kagezou.io.files.faults import output_problem
from kagezou.io.project.file import load, save
from kagezou.io.project.file_state import NEVER_SEEN, state_of
from kagezou.io.project.open_elsewhere import open_elsewhere
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

STEPS: Final = 100_000
"""The steps of a cut, of which those that are done are told."""

_READ, _ON_FEET, _EXPORTED = 10_000, 25_000, 95_000
"""How many of them reading, looking for feet and the output are over with."""


@dataclass(frozen=True, slots=True)
class Doing:
    """What a cut is made with.

    Parameters
    ----------
    open_context
        Makes an OpenGL context.
    progress
        Told how many of `STEPS` are done.
    cancelled
        Asked whether to stop.
    """

    open_context: OpenContext
    progress: Progress
    cancelled: Cancelled

    def part(self, first: int, last: int) -> Progress:
        """Return what is told how far one part is."""
        return lambda done, whole: self.progress(first + (last - first) * done // max(whole, 1), STEPS)

    def loading(self, first: int, last: int) -> Callable[[LoadPhase, int, int], None]:
        """Return the same for what reads files, which is ended from there."""
        tell = self.part(first, last)

        def watch(_phase: LoadPhase, done: int, whole: int) -> None:
            if self.cancelled():
                raise LoadCancelled
            tell(done, whole)

        return watch


@dataclass(frozen=True, slots=True)
class MadeCut:
    """What came of a cut, and the problem that ended it, if one did."""

    record: CutRecord
    problem: Problem | None = None


def make_cut(cut: Cut, orders: Orders, doing: Doing) -> MadeCut:
    """Make project and output of a cut, and write down how it went; whatever is wrong with the cut is kept with it.

    Raises
    ------
    OutputProblem, DiskFullProblem
        Nothing can be written into the folder of the cut.
    """
    started, folder = time.monotonic(), orders.output / cut.name
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    if (there := unchanged(cut, orders)) is not None:
        made = MadeCut(there)
    else:
        making = _Making(cut, orders, doing, read_record(folder))
        made = making.made()
        made = replace(made, record=replace(made.record, seconds=time.monotonic() - started))
    write_record(made.record, folder)
    return made


def unchanged(cut: Cut, orders: Orders) -> CutRecord | None:
    """Return the record of a cut that is left alone, as it would come out the same; None where it is to be made."""
    before = read_record(orders.output / cut.name) if orders.skip_existing else None
    return kept(before) if before is not None and _is_as_it_was(before, cut, orders) else None


def _is_as_it_was(before: CutRecord, cut: Cut, orders: Orders) -> bool:
    """Return whether a cut would come out the same, and all that came of it is still there."""
    folder = orders.output / cut.name
    if not before.is_whole or before.made_of != made_of(cut.path, before.folders, orders):
        return False
    if state_of(folder / before.project) != before.seen:
        return False
    try:
        return all((folder / name).stat().st_size == size for name, size in before.files)
    except OSError:
        return False


class _Making:
    """A cut under way: what is known of it so far.

    Parameters
    ----------
    cut, orders, doing
        What is made, as what, and with what.
    before
        How it went the last time.
    """

    def __init__(self, cut: Cut, orders: Orders, doing: Doing, before: CutRecord | None) -> None:
        self._cut, self._orders, self._doing = cut, orders, doing
        self._before = before
        self._folder = orders.output / cut.name
        self._project = self._folder / f"{cut.name}.kage"
        self._record = CutRecord(name=cut.name, state=State.STOPPED)
        self._files_at_first = made_of(cut.path, (), orders)

    def made(self) -> MadeCut:
        """Make it, and return how that went."""
        try:
            document = self._with_project()
            self._learn(document)
            came = self._exported(document)
            self._take_in(came)
            self._see_that_files_stayed()
            tell = self._doing.part(_EXPORTED, STEPS)
            pictures = thumbnails(document, self._record.doubtful, self._doing.open_context, tell)
            self._record = replace(self._record, thumbnails=pictures)
            self._doing.progress(STEPS, STEPS)
        except LoadCancelled:
            return MadeCut(self._record)
        except Problem as problem:
            return MadeCut(replace(self._record, state=State.FAILED, problem=problem.message), problem)
        if came.cancelled:
            return MadeCut(self._record)
        if came.problem is not None or not came.is_whole:
            lost = came.files - came.there
            words = Message("{failed} of {files} frames failed", failed=lost, files=came.files)
            told = words if came.problem is None else Message("{problem} ({lost})", problem=came.problem, lost=words)
            failed = replace(self._record, state=State.FAILED, problem=told)
            return MadeCut(failed, SomeFramesFailed(told))
        return self._handed_on(document, came)

    def _handed_on(self, document: Document, came: ExportOutcome) -> MadeCut:
        """Run what comes after the output; where it fails the cut has failed, though its output is whole."""
        kind = EXPORTS[self._orders.export].key
        over = Handover(kind, document, self._project, came.made, is_whole=True, notes=came.notes)
        try:
            said = hand_on(over, hooks_of(self._orders.after), self._doing.cancelled)
        except Problem as problem:
            if self._doing.cancelled():
                return MadeCut(self._record)
            return MadeCut(replace(self._record, state=State.FAILED, problem=problem.message), problem)
        return MadeCut(replace(self._record, state=State.DONE, notes=(*self._record.notes, *said)))

    def _with_project(self) -> Document:
        """Return the document of the project, which is written; one that somebody changed since stays as it is."""
        there = state_of(self._project)
        was = NEVER_SEEN if self._before is None else self._before.saved
        if there is not None and there != was and not self._orders.renew:
            note = Message("its project was changed by hand: it stays as it is, and the output is made of it")
            self._record = replace(self._record, notes=(note,), project=self._project.name, saved=was, seen=there)
            return load(self._project)
        imported = self._brought()
        if (said := open_elsewhere(self._project)) is not None:
            imported = replace(imported, notes=(*imported.notes, said))
        state = save(imported.document, self._project)
        self._record = replace(self._record, notes=imported.notes, project=self._project.name, saved=state, seen=state)
        return imported.document

    def _brought(self) -> Imported:
        """Return the document of the cut's files, on its feet, lit and styled as asked."""
        orders = self._orders
        template = None if orders.template is None else load(orders.template)
        whole = None if orders.parts else template
        imported = document_of_cut(cut_files(self._cut.path), whole, self._doing.loading(0, _READ))
        if template is not None and orders.parts:
            imported = with_parts(imported, template, orders.parts)
        document, notes = imported.document, list(imported.notes)
        ids = [layer.id for layer in document.layers]
        on_feet = document_with_feet(document, ids, self._doing.loading(_READ, _ON_FEET))
        document = on_feet.document
        doubts = [note for each in ids for note in doubt_notes(document, each)]
        notes += [note for note in on_feet.notes if note not in doubts]
        if orders.style is not None:
            figures = [layer.id for layer in document.layers if layer.joins is None]
            document = put_style(document, figures, orders.style, 1, with_light=orders.with_light).document
        return replace(imported, document=document, notes=tuple(dict.fromkeys(notes)))

    def _learn(self, document: Document) -> None:
        """Take down what the cut is like."""
        canvas = document.canvas
        folders = folders_of(self._cut.path, document)
        self._record = replace(
            self._record,
            layers=tuple(layer.name for layer in document.layers),
            frames=canvas.length_frames,
            rate=float(canvas.frame_rate),
            size_px=(canvas.width_px, canvas.height_px),
            doubtful=doubtful_frames(document),
            folders=folders,
            made_of=made_of(self._cut.path, folders, self._orders),
        )

    def _exported(self, document: Document) -> ExportOutcome:
        orders, doing = self._orders, self._doing
        exporter = EXPORTS[orders.export]
        choices = ExportChoices(
            kind=exporter.key,
            format=exporter.formats(ExportChoices(kind=exporter.key))[0],
            skip_existing=orders.skip_existing,
            missing=orders.missing.value,
        )
        place = Place(self._folder, self._project, self._cut.name)
        request = replace(exporter.request(document, choices, place), workers=orders.workers)
        if isinstance(request, ExportRequest):
            request = replace(request, keep_going=True)
        tell = doing.part(_ON_FEET, _EXPORTED)
        made = exporter.export(document, request, doing.open_context, tell, doing.cancelled)
        return replace(exporter.outcome(made, place), made=exporter.made_files(made))

    def _see_that_files_stayed(self) -> None:
        """Say where files of the cut changed meanwhile, and let it be made anew the next time."""
        if made_of(self._cut.path, (), self._orders) != self._files_at_first:
            note = Message("its files changed while it was made, so it is made again the next time")
            self._record = replace(self._record, made_of="", notes=(*self._record.notes, note))

    def _take_in(self, came: ExportOutcome) -> None:
        """Take down what the output is."""
        where = came.where if came.where.exists() else self._folder
        self._record = replace(
            self._record,
            where=where.relative_to(self._folder).as_posix() if where != self._folder else "",
            files=tuple(_files_in(self._folder)),
            counts=tuple((each.kind, each.there, each.files) for each in came.counts),
            notes=tuple(dict.fromkeys((*self._record.notes, *came.notes))),
        )


def _files_in(folder: Path) -> list[tuple[str, int]]:
    """Return the files of an output and their sizes, without hidden ones and without projects, which are looked at.

    Raises
    ------
    OutputProblem
        The system refuses to tell.
    """
    try:
        found = (path for path in sorted(folder.rglob("*")) if path.is_file() and not path.suffix.startswith(".kage"))
        inside = [(path.relative_to(folder), path.stat().st_size) for path in found]
    except OSError as error:
        raise output_problem(folder, error) from error
    return [(name.as_posix(), size) for name, size in inside if not any(part[:1] == "." for part in name.parts)]
