"""Exporting a cut as the scene of another program: each layer's pictures into a folder, the scene last."""

import time
from contextlib import closing, suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Final

from kagezou.document.model import Document
from kagezou.errors import Stopped, UsageProblem
from kagezou.export.checks import check_sources, prepare_folders
from kagezou.export.exchange.drawn import DrawnLayer, Packer, Who, layers_of
from kagezou.export.exchange.gathering import Gathered, ordered
from kagezou.export.exchange.stack import SceneTarget
from kagezou.export.file_kinds import LAYER_PICTURES, SCENE, FileCount
from kagezou.export.frames import CEL_BUDGET_BYTES, decode, stops_of
from kagezou.export.layered import LayeredContent
from kagezou.export.made_files import SCENE as SCENE_FILE
from kagezou.export.made_files import MadeFile
from kagezou.export.painters import Painters, are_worth_two
from kagezou.export.pipeline import PipelineSteps, flow, window_for
from kagezou.export.planning import Plan
from kagezou.export.request import Cancelled, ExportRequest, Missing, Progress
from kagezou.export.stand_ins import planned_without_missing
from kagezou.io.files.atomic import write_bytes
from kagezou.io.images.cel_cache import CelCache
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext

MAX_SIDE_PX: Final = 16384


@dataclass(frozen=True, slots=True)
class SceneRequest:
    """What to hand over.

    Parameters
    ----------
    folder
        Where everything goes.
    name
        What the cut is called.
    file
        The name of the scene's file.
    target
        Whom it is for.
    frames
        Frame numbers that follow one another; None for the whole cut.
    depth
        Bits a channel of the pictures, 8 or 16.
    workers
        Threads that read and pack.
    missing
        What stands in for a drawing that is not there.
    """

    folder: Path
    name: str
    file: str
    target: SceneTarget
    frames: tuple[int, ...] | None = None
    depth: int = 8
    workers: int = 2
    missing: Missing = Missing.FAIL

    @property
    def frames_wanted(self) -> ExportRequest:
        """The frames of layers that its pictures come from; nothing is written by it."""
        return ExportRequest(
            self.folder,
            frames=self.frames,
            format="psd",
            depth=self.depth,
            workers=self.workers,
            layered=True,
            missing=self.missing,
        )


@dataclass(frozen=True, slots=True)
class SceneMade:
    """What came of it.

    Parameters
    ----------
    scene
        The scene's file; None where the export was stopped before everything it needs was there.
    counts
        The files by what they are.
    written
        How many files were written.
    notes
        What the user should know, one sentence each.
    made
        The files one by one.
    """

    scene: Path | None
    counts: tuple[FileCount, ...]
    written: int
    notes: tuple[Message, ...]
    seconds: float
    made: tuple[MadeFile, ...] = ()


def export_scene(
    document: Document, request: SceneRequest, open_context: OpenContext, progress: Progress, cancelled: Cancelled
) -> SceneMade:
    """Write the pictures of every layer and, when all of them are there, the scene.

    Raises
    ------
    UsageProblem
        There is nothing to make, or the canvas is too large.
    InputProblem
        A drawing is missing and nothing stands in for it, or cannot be read.
    DiskFullProblem, OutputProblem
        A place refuses.
    GraphicsProblem
        There is no OpenGL, or it failed.
    """
    started = time.monotonic()
    canvas = document.canvas
    if max(canvas.width_px, canvas.height_px) > MAX_SIDE_PX:
        raise UsageProblem(Message("a scene has at most {most} px a side, the canvas has more", most=MAX_SIDE_PX))
    plan = planned_without_missing(document, request.frames_wanted)
    check_sources(plan.jobs)
    run = _SceneRun(document, request, plan, progress, cancelled, _gathering(document, request, plan))
    scene: Path | None = None
    notes: tuple[Message, ...] = ()
    with suppress(Stopped):
        run.draw(open_context)
        scene, notes = run.finish()
    pictures = run.gathered.files
    counts = (FileCount(LAYER_PICTURES, pictures, pictures), FileCount(SCENE, int(scene is not None), 1))
    written = pictures + int(scene is not None)
    made = (*run.gathered.made(), *(() if scene is None else (MadeFile(scene, SCENE_FILE),)))
    return SceneMade(scene, counts, written, notes, time.monotonic() - started, made)


def scene_layers(plan: Plan) -> tuple[Who, ...]:
    """Return the layers that the scene of a plan has, from the bottom."""
    return ordered(layers_of(job.content) for job in plan.jobs if isinstance(job.content, LayeredContent))


def _gathering(document: Document, request: SceneRequest, plan: Plan) -> Gathered:
    return Gathered(
        folder=request.folder.absolute(),
        name=request.name,
        depth=request.depth,
        canvas=document.canvas,
        frames=tuple(sorted(target.frame for job in plan.jobs for target in job.targets)),
        every_frame=request.target.every_frame,
        layers=scene_layers(plan),
        pictures=request.target.pictures,
        separator=request.target.separator,
    )


@dataclass(slots=True)
class _SceneRun:
    """One export under way."""

    document: Document
    request: SceneRequest
    plan: Plan
    progress: Progress
    cancelled: Cancelled
    gathered: Gathered
    done: int = 0

    @property
    def _steps(self) -> int:
        """All there are: each frame drawn, each laid out where every one has a file, and the scene."""
        return len(self.gathered.frames) * (2 if self.request.target.every_frame else 1) + 1

    def draw(self, open_context: OpenContext) -> None:
        """Draw the layers of every frame and write each different picture once; raises Stopped."""
        canvas, request = self.document.canvas, self.request
        cels = CelCache(CEL_BUDGET_BYTES)
        stops, are_two = (
            stops_of(self.document, self.cancelled),
            are_worth_two(self.document, self.plan.jobs, request.workers),
        )
        painters = Painters(cels, request.depth, open_context, stops, keeps_opacity=True, are_two=are_two)
        steps: PipelineSteps[tuple[DrawnLayer, ...]] = PipelineSteps(
            decode=partial(decode, cels, in_color=True),
            drawing=painters.drawing,
            write=Packer().pack,
            drawing_beside=painters.drawing_beside,
        )
        self._prepare()
        window = window_for(canvas.width_px, canvas.height_px, request.workers)
        with closing(flow(self.plan.jobs, steps, request.workers, window, self.cancelled)) as outcomes:
            for outcome in outcomes:
                if outcome.problem is not None:
                    raise outcome.problem
                frames = tuple(target.frame for target in outcome.job.targets)
                self.gathered.take(frames, outcome.written or ())
                self._step(len(outcome.job.targets))
        if self.done < len(self.gathered.frames):
            raise Stopped

    def finish(self) -> tuple[Path, tuple[Message, ...]]:
        """Lay out what every frame has, remove what an earlier export left, and write the scene; raises Stopped."""
        for _ in self.gathered.laid_out():
            self._step(1)
            if self.cancelled():
                raise Stopped
        self.gathered.remove_others()
        stack, notes = self.gathered.stack()
        made = self.request.target.write(stack)
        path = self.gathered.folder / self.request.file
        write_bytes(path, made.text.encode("utf-8"))
        self._step(1)
        return path, (*self.plan.notes, *notes, *made.notes)

    def _prepare(self) -> None:
        """See whether there is room and whether the folder can be written to."""
        folder = self.gathered.folder / self.gathered.pictures
        sequences = tuple(replace(each, name=replace(each.name, folder=folder)) for each in self.plan.sequences)
        prepare_folders(self.request.frames_wanted, Plan(self.plan.jobs, sequences, {}))

    def _step(self, count: int) -> None:
        self.done += count
        self.progress(self.done, self._steps)
