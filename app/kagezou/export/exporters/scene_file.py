"""Scenes of other programs: the pictures of every layer, and one file that lays them on each other there."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exchange.export import SceneMade, SceneRequest, export_scene, scene_layers
from kagezou.export.exchange.gathering import labels_of
from kagezou.export.exchange.stack import SceneTarget
from kagezou.export.exporters.exporter import Exporter, ExportOutcome, Option
from kagezou.export.exporters.numbered_frames import frames_chosen, workers
from kagezou.export.made_files import MadeFile
from kagezou.export.names import safe_names
from kagezou.export.planning import planned
from kagezou.export.request import Cancelled, Missing, Progress
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneFile(Exporter[SceneRequest, SceneMade]):
    """A scene for one program.

    Parameters
    ----------
    program
        What the command line calls the program.
    target
        What writes its scenes.
    steps
        Says what to do with the scene of a file's name, in one or two sentences.
    """

    program: str
    target: SceneTarget
    steps: Callable[[str], tuple[Message, ...]]

    def lacks(self) -> None:
        """Return nothing: the program may be on another machine."""

    def formats(self, _choices: ExportChoices) -> tuple[str, ...]:
        """Return the one format that all of them read alike."""
        return ("png",)

    def is_layered(self, _choices: ExportChoices) -> bool:
        """Return False."""
        return False

    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return the scene and the folders of its layers, the uppermost first, and at most how many files each gets."""
        request = self.request(document, choices, place)
        plan = planned(document, request.frames_wanted)
        length = sum(len(job.targets) for job in plan.jobs)
        labels = reversed(labels_of(scene_layers(plan)).values())
        return (request.file, f"{self.target.pictures}/", *(f"    {label}/  ≤ {length} × .png" for label in labels))

    def request(self, document: Document, choices: ExportChoices, place: Place) -> SceneRequest:
        """Return what the scene is asked for with."""
        return SceneRequest(
            folder=place.folder,
            name=place.name,
            file=self.file(place.name),
            target=self.target,
            frames=frames_chosen(document, choices),
            depth=choices.depth,
            workers=workers(),
            missing=Missing(choices.missing),
        )

    def export(
        self,
        document: Document,
        request: SceneRequest,
        open_context: OpenContext,
        progress: Progress,
        cancelled: Cancelled,
    ) -> SceneMade:
        """Write pictures and scene."""
        return export_scene(document, request, open_context, progress, cancelled)

    def outcome(self, made: SceneMade, place: Place) -> ExportOutcome:
        """Return what came of it; the scene is what to look for."""
        return ExportOutcome(
            counts=made.counts,
            written=made.written,
            cancelled=made.scene is None,
            problem=None,
            where=made.scene or place.folder,
            notes=made.notes,
        )

    def made_files(self, made: SceneMade) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""
        return made.made

    def next_steps(self, _document: Document, _choices: ExportChoices, place: Place) -> tuple[Message, ...]:
        """Return how the scene is opened."""
        movable = Message("The scene finds its pictures beside itself: move the folder as a whole.")
        return (*self.steps(self.file(place.name)), movable)

    def file(self, name: str) -> str:
        """Return what the scene's file is called; where a program imports it by name, in letters that it takes."""
        if self.target.is_module:
            name = re.sub(r"[^A-Za-z0-9_]", "_", name)
            return f"{self.program}_{name}{self.target.suffix}"
        return f"{safe_names([name])[name]}{self.target.suffix}"


SCENE_OPTIONS: Final = frozenset((Option.DEPTH, Option.ONLY_WORK_AREA, Option.MISSING))
"""What any scene lets one choose."""
