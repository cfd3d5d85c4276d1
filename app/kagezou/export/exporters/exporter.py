"""What every kind of export has: words, options, a request made of choices, a preview, and the work itself."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from pathlib import Path
from typing import Generic, TypeVar

from kagezou.document.model import Document
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.file_kinds import FileCount
from kagezou.export.made_files import MadeFile
from kagezou.export.request import Cancelled, Progress
from kagezou.extras import Extra
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
    MISSING = "missing"
    IN_ONE = "in_one"
    PER_DRAWING = "per_drawing"
    COPIES = "copies"
    MATTES = "mattes"
    CONTROLS = "controls"
    CHUNK = "chunk"
    NAMES = "names"
    VIDEO_LAYER = "video_layer"


@dataclass(frozen=True, slots=True)
class ExportOutcome:
    """What came of an export.

    Parameters
    ----------
    counts
        The files by what they are.
    written
        How many of them are new.
    cancelled
        Whether it was stopped.
    problem
        The first thing that went wrong.
    where
        The folder, or the one file that is to be looked for.
    notes
        What the user should know, one sentence each.
    next_steps
        What to do with it in the program that it is for.
    made
        The files one by one.
    """

    counts: tuple[FileCount, ...]
    written: int
    cancelled: bool
    problem: Message | None
    where: Path
    notes: tuple[Message, ...] = ()
    next_steps: tuple[Message, ...] = ()
    made: tuple[MadeFile, ...] = ()

    @property
    def files(self) -> int:
        """How many files were asked for."""
        return sum(each.files for each in self.counts)

    @property
    def there(self) -> int:
        """How many of them are there, whole."""
        return sum(each.there for each in self.counts)

    @property
    def is_whole(self) -> bool:
        """Whether all of them are."""
        return self.there == self.files


@dataclass(frozen=True, slots=True)
class Lack:
    """What a machine lacks for an exporter: in words without a full stop, and as a part of the program."""

    says: Message
    extra: Extra


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
    purpose
        What it is for, in a few words.
    icon
        The name of its icon.
    verb
        The command of the command line that makes it.
    options
        What it lets one choose.
    """

    key: str
    label: Message
    purpose: Message
    icon: str
    verb: str
    options: frozenset[Option]

    @abstractmethod
    def lacks(self) -> Lack | None:
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

    @abstractmethod
    def made_files(self, made: Made) -> tuple[MadeFile, ...]:
        """Return the files that are there, one by one."""

    @abstractmethod
    def next_steps(self, document: Document, choices: ExportChoices, place: Place) -> tuple[Message, ...]:
        """Return what to do with it in the program that it is for, in two or three short sentences."""

    def steps_after(
        self, came: ExportOutcome, document: Document, choices: ExportChoices, place: Place
    ) -> tuple[Message, ...]:
        """Return what to do next: with what was made, or for the rest to be made."""
        if came.is_whole:
            return self.next_steps(document, choices, place)
        if Option.SKIP_EXISTING not in self.options:
            return (Message("It is there as a whole or not at all: export again to make it."),)
        return (
            Message("Every file that is there is whole and stays."),
            Message(
                "Export again with “Leave frames alone that would come out the same” ticked: it goes on where it was."
            ),
        )

    def work(self, document: Document, choices: ExportChoices, place: Place) -> Work:
        """Return what carries the choices out."""

        def work(open_context: OpenContext, progress: Progress, cancelled: Cancelled) -> ExportOutcome:
            request = self.request(document, choices, place)
            made = self.export(document, request, open_context, progress, cancelled)
            came = replace(self.outcome(made, place), made=self.made_files(made))
            return replace(came, next_steps=self.steps_after(came, document, choices, place))

        return work
