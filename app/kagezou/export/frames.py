"""Exporting frames: from a document and a request to whole files and a summary."""

import time
from collections import Counter
from collections.abc import Iterable, Sequence
from contextlib import closing
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Final

from kagezou.document.model import Document
from kagezou.export.checks import check_sources, check_targets, prepare_folders
from kagezou.export.contents import Content
from kagezou.export.file_kinds import FileCount, added_up, kind_of
from kagezou.export.forks import Sharing, processes_for, shared_flow
from kagezou.export.ledger import Ledger, fingerprint
from kagezou.export.made_files import MadeFile
from kagezou.export.painters import Painters, are_worth_two
from kagezou.export.pipeline import Outcome, PipelineSteps, window_for
from kagezou.export.planning import FrameJob, OutputFile, Plan
from kagezou.export.request import Cancelled, ExportRequest, Failure, Progress, Summary
from kagezou.export.stand_ins import planned_without_missing
from kagezou.export.writing import write_all
from kagezou.io.files.atomic import sweep_stale
from kagezou.io.images.cel_cache import CelCache
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext
from kagezou.scene.heavy_sets import heavy_words

CEL_BUDGET_BYTES: Final = 256 << 20


def export_frames(
    document: Document, request: ExportRequest, open_context: OpenContext, progress: Progress, cancelled: Cancelled
) -> Summary:
    """Write the frames that ``request`` asks for; every file is whole or not there.

    Equal pictures are drawn and encoded once. The bytes depend neither on the number of workers nor on the order.

    Raises
    ------
    UsageProblem
        The request does not fit the document.
    InputProblem
        A drawing is missing or cannot be read, unless the request keeps going.
    DiskFullProblem, OutputProblem
        A place refuses; the frames before it are whole.
    GraphicsProblem
        There is no OpenGL, or it failed.
    """
    started = time.monotonic()
    request = replace(request, folder=request.folder.absolute())
    plan = planned_without_missing(document, request)
    if not request.keep_going:
        check_sources(plan.jobs)
    check_targets(plan)
    prepare_folders(request, plan)
    for folder in plan.folders:
        sweep_stale(folder)
    run = _Run(plan, request, Ledger(request.folder), progress)
    jobs = run.outstanding(cancelled)
    if jobs:
        _make(run, jobs, document, open_context, cancelled)
    return run.summary(time.monotonic() - started)


def _make(
    run: "_Run", jobs: list[FrameJob], document: Document, open_context: OpenContext, cancelled: Cancelled
) -> None:
    """Make the outstanding files."""
    request, canvas = run.request, document.canvas
    processes = processes_for(document, jobs, request.workers)
    cels = CelCache(CEL_BUDGET_BYTES // processes)
    window = window_for(canvas.width_px, canvas.height_px, request.workers)
    stops = stops_of(document, cancelled)
    painters = Painters(
        cels,
        request.depth,
        open_context,
        stops,
        keeps_opacity=request.keeps_opacity,
        are_two=processes < 2 and are_worth_two(document, jobs, request.workers),
        processes=processes,
    )
    steps = PipelineSteps(
        decode=partial(decode, cels, in_color=request.composite or request.layered),
        drawing=painters.drawing,
        write=write_all,
        drawing_beside=painters.drawing_beside,
    )
    sharing = Sharing(request.workers, window, processes)
    with closing(shared_flow(jobs, steps, sharing, cancelled, run.notes.append)) as outcomes:
        for outcome in outcomes:
            run.note(outcome)


def stops_of(document: Document, cancelled: Cancelled) -> Cancelled:
    """Return what stops within a frame: whatever stops between two of them, where a frame takes minutes."""
    return cancelled if heavy_words(document) is not None else lambda: False


def decode(cels: CelCache, job: FrameJob, *, in_color: bool) -> None:
    """Bring the drawings of a job into memory; in colour at once where a composite will want them so."""
    sources = job.content.sources
    for source in sources.cels:
        cels.cel(source)
    for source in sources.mattes:
        if in_color:
            cels.cel(source)
        else:
            cels.matte(source)


@dataclass(slots=True)
class _Run:
    """An export under way: what it is to make, and what has come of it so far."""

    plan: Plan
    request: ExportRequest
    ledger: Ledger
    progress: Progress
    trusted: int = 0
    written: int = 0
    drawn: int = 0
    failures: list[Failure] = field(default_factory=list)
    made: list[MadeFile] = field(default_factory=list)
    fingerprints: dict[Content, str] = field(default_factory=dict)
    there: Counter[Message] = field(default_factory=Counter)
    notes: list[Message] = field(default_factory=list)

    def outstanding(self, cancelled: Cancelled) -> list[FrameJob]:
        """Return the jobs with the files that are still to be made; none where that was stopped."""
        jobs: list[FrameJob] = []
        for job in self.plan.jobs:
            if self.request.skip_existing and cancelled():
                return []
            made_of = self.fingerprints[job.content] = fingerprint(job, self.request)
            targets = job.targets
            if self.request.skip_existing and self.request.anew.isdisjoint(job.content.sources.files):
                targets = tuple(target for target in targets if not self.ledger.holds(target.path, made_of))
                self._trust([target for target in job.targets if target not in targets])
            if targets:
                jobs.append(job.only(targets))
        return jobs

    def note(self, outcome: Outcome[str]) -> None:
        """Take in what came of a job; InputProblem if it failed and the others are not to go on without it."""
        job = outcome.job
        if outcome.problem is not None:
            if not self.request.keep_going:
                raise outcome.problem
            self.failures.append(Failure(tuple(target.frame for target in job.targets), outcome.problem.message))
            return
        for target in job.targets:
            self.ledger.add(target.path, self.fingerprints[job.content], outcome.written or "")
        self.made += (each.made(outcome.written or "", is_new=True) for each in outcome.job.targets)
        self.drawn += 1
        self.written += len(job.targets)
        self._count(job.targets)

    def _trust(self, targets: Sequence[OutputFile]) -> None:
        """Take in files that are whole already."""
        if targets:
            self.made += (each.made(self.ledger.hash_of(each.path), is_new=False) for each in targets)
            self.trusted += len(targets)
            self._count(targets)

    def _count(self, targets: Iterable[OutputFile]) -> None:
        self.there.update(kind_of(target.sequence.subject) for target in targets)
        self.progress(self.trusted + self.written, self.plan.files)

    def summary(self, seconds: float) -> Summary:
        """Return what came of it all."""
        failed = sum(len(failure.frames) for failure in self.failures)
        files = (target.path for job in self.plan.jobs for target in job.targets)
        order = {path: place for place, path in enumerate(files)}
        return Summary(
            files=self.plan.files,
            written=self.written,
            drawn=self.drawn,
            trusted=self.trusted,
            failures=tuple(self.failures),
            cancelled=self.trusted + self.written + failed < self.plan.files,
            folders=self.plan.folders,
            names=self.plan.names,
            seconds=seconds,
            notes=(*self.plan.notes, *self.notes),
            counts=self._counts(),
            made=tuple(sorted(self.made, key=lambda each: order[each.path])),
        )

    def _counts(self) -> tuple[FileCount, ...]:
        """Return how many files of each kind there are, in the order of the sequences."""
        kinds = dict.fromkeys(kind_of(each.subject) for each in self.plan.sequences)
        asked = Counter(kind_of(target.sequence.subject) for job in self.plan.jobs for target in job.targets)
        return added_up(FileCount(kind, self.there[kind], asked[kind]) for kind in kinds)
