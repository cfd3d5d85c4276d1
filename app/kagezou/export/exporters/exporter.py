"""What every kind of export has: words, options, a request made of choices, a preview, and the work itself."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import Generic, TypeVar

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.request import Cancelled, Progress
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext


class Option(StrEnum):
    """What may be chosen beside the format: fields of `ExportChoices`."""

    DEPTH = "depth"
    COMPOSITE = "composite"
    RECEIVERS = "receivers"
    UNITED = "united"
    ONLY_WORK_AREA = "only_work_area"
    SKIP_EXISTING = "skip_existing"
    IN_ONE = "in_one"
    PER_DRAWING = "per_drawing"
    COPIES = "copies"
    MATTES = "mattes"
    CHUNK = "chunk"
    VIDEO_LAYER = "video_layer"


@dataclass(frozen=True, slots=True)
class ExportOutcome:
    """What came of it: files asked for and new, whether it was stopped, the first problem, where to look, and notes."""

    files: int
    written: int
    cancelled: bool
    problem: Message | None
    where: Path
    notes: tuple[Message, ...] = ()


Work = Callable[[OpenContext, Progress, Cancelled], ExportOutcome]
"""An export to be carried out, on any thread; it may raise a Problem."""

Request = TypeVar("Request")
"""What it is asked for with."""
Made = TypeVar("Made")
"""What it says it has made."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Exporter(ABC, Generic[Request, Made]):
    """One kind of export.

    Parameters
    ----------
    key
        What it is remembered by in settings and presets.
    label
        What the window calls it.
    verb
        The command of the command line that makes it.
    options
        What it lets one choose.
    """

    key: str
    label: Message
    verb: str
    options: frozenset[Option]

    @abstractmethod
    def lacks(self) -> Message | None:
        """Return what this machine lacks for it; None where it can be made."""

    @abstractmethod
    def formats(self, choices: ExportChoices) -> tuple[str, ...]:
        """Return the formats it may have, the usual one first."""

    @abstractmethod
    def is_layered(self, choices: ExportChoices) -> bool:
        """Return whether each frame is one file that holds all layers, so that a composite would say it again."""

    @abstractmethod
    def preview(self, document: Document, choices: ExportChoices, place: Place) -> tuple[str, ...]:
        """Return what would be written, a line for each folder; indented below it what is in its files.

        Raises
        ------
        UsageProblem
            There is nothing to export, or the project must be saved first.
        """

    @abstractmethod
    def request(self, document: Document, choices: ExportChoices, place: Place) -> Request:
        """Return what the export is asked for with.

        Raises
        ------
        UsageProblem
            The choices cannot be had, or the project must be saved first.
        OutputProblem, DiskFullProblem
            The place refuses.
        """

    @abstractmethod
    def export(
        self,
        document: Document,
        request: Request,
        open_context: OpenContext,
        progress: Progress,
        cancelled: Cancelled,
    ) -> Made:
        """Make what is asked for; it may raise a Problem."""

    @abstractmethod
    def outcome(self, made: Made, place: Place) -> ExportOutcome:
        """Return what came of it, as every kind of export tells it."""

    def work(self, document: Document, choices: ExportChoices, place: Place) -> Work:
        """Return what carries the choices out."""

        def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
            request = self.request(document, choices, place)
            return self.outcome(self.export(document, request, open_context, progress, cancelled), place)

        return work
