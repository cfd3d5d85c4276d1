"""What is asked for and what came of it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Final

from kagezou.errors import UsageProblem
from kagezou.export.file_names import FileNames
from kagezou.message import Message

if TYPE_CHECKING:  # what is asked for is looked at before all that makes it is imported
    from kagezou.export.file_kinds import FileCount
    from kagezou.export.made_files import MadeFile

SUFFIXES: Final = {"png": ".png", "tga": ".tga", "tiff": ".tif", "exr": ".exr"}
"""The formats and the suffix of their files."""

LAYERED_SUFFIXES: Final = {"psd": ".psd", "exr": ".exr"}
"""The formats of frames that hold all layers in one file, and the suffix of their files."""

DEPTHS: Final = {"png": (8, 16), "tga": (8,), "tiff": (8, 16), "exr": (16,), "psd": (8, 16)}
"""The bits a channel that each format holds, the usual one first."""

MAX_WORKERS: Final = 64

SHADOWS: Final = "shadows"
RECEIVED: Final = "received"
CONTACTS: Final = "contacts"
REFLECTIONS: Final = "reflections"
CLAY: Final = "clay"
TOGETHER: Final = "together"
RECEIVERS: Final = "receivers"
"""What may be asked for alone: shadows on the ground and the set, what characters cast on each other, the patches under
their feet, their reflections, sets drawn as clay, shadows that go over together, or where ground and set are seen."""


class Missing(StrEnum):
    """What is made of a frame whose drawing is missing: nothing at all, the frame without it, or with its neighbour."""

    FAIL = "fail"
    EMPTY = "empty"
    HOLD = "hold"


@dataclass(frozen=True, slots=True)
class ExportRequest:
    """Which frames of a document to write, where, and how.

    Parameters
    ----------
    folder
        Where the layers' folders are made.
    frames
        Frame numbers, upward; None for the whole cut.
    layers
        Names of layers; None for every layer that is ever visible.
    format, depth
        A key of `SUFFIXES`, for layered frames of `LAYERED_SUFFIXES`, and bits a channel out of `DEPTHS`.
    composite
        Whether to write background, shadows and characters in one picture as well.
    skip_existing
        Whether to trust frames that an earlier export has finished and that would come out the same.
    workers
        Threads that decode and encode; drawing has its own. They are shared by processes where those can be forked.
    keep_going
        Whether the other frames are made when a drawing cannot be read.
    once
        Whether each different picture of a layer is written once, numbered from 1 in the order in which they appear,
        instead of a file for every frame.
    layered
        Whether each frame is one file that holds background, shadows and characters as layers, instead of a folder
        for each shadow.
    only
        `SHADOWS`, `RECEIVED`, `CONTACTS`, `REFLECTIONS`, `CLAY`, `TOGETHER` or `RECEIVERS`; None for all but the last
        two.
    receivers
        Whether mattes of the ground and of every set piece are written as well.
    united
        Whether the shadows of each look are written as one as well.
    guides
        Whether ground, set and feet are drawn as lines into the composites, for looking at them.
    names
        How the files are called.
    anew
        Files whose pictures are made even where ``skip_existing`` would trust them.
    missing
        What stands in for a drawing that is not there.
    """

    folder: Path
    frames: tuple[int, ...] | None = None
    layers: tuple[str, ...] | None = None
    format: str = "png"
    depth: int = 8
    composite: bool = False
    skip_existing: bool = False
    workers: int = 2
    keep_going: bool = False
    once: bool = False
    layered: bool = False
    only: str | None = None
    receivers: bool = False
    united: bool = False
    guides: bool = False
    names: FileNames = field(default_factory=FileNames)
    anew: frozenset[Path] = frozenset()
    missing: Missing = Missing.FAIL

    def __post_init__(self) -> None:
        if self.layered and self.format not in LAYERED_SUFFIXES:
            raise UsageProblem(
                Message("layered frames cannot be written as {format!r}, only as psd or exr", format=self.format)
            )
        if self.layered and self.composite:
            raise UsageProblem(Message("a layered frame holds what a composite is made of; ask for one of the two"))
        if self.layered and self.united:
            raise UsageProblem(
                Message("a layered frame holds the shadows of a look as a group; ask for one of the two")
            )
        if self.guides and not self.composite:
            raise UsageProblem(Message("guides are drawn into composites; ask for those as well"))
        if not self.layered and self.format not in SUFFIXES:
            hint = Message(", which needs layered frames,") if self.format in LAYERED_SUFFIXES else ""
            raise UsageProblem(
                Message(
                    "frames cannot be written as {format!r}{hint} only as {suffixes}",
                    format=self.format,
                    hint=hint,
                    suffixes=", ".join(SUFFIXES),
                )
            )
        if self.depth not in DEPTHS[self.format]:
            depths = " or ".join(str(depth) for depth in DEPTHS[self.format])
            raise UsageProblem(
                Message(
                    "{format} frames have {depths} bits a channel, not {depth}",
                    format=self.format,
                    depths=depths,
                    depth=self.depth,
                )
            )
        if not 1 <= self.workers <= MAX_WORKERS:
            raise UsageProblem(
                Message("{workers} workers are not 1 to {most_workers}", workers=self.workers, most_workers=MAX_WORKERS)
            )

    @property
    def suffix(self) -> str:
        """The suffix of its files."""
        return (LAYERED_SUFFIXES if self.layered else SUFFIXES)[self.format]

    @property
    def keeps_opacity(self) -> bool:
        """Whether its files hold the opacity of a layer beside its alpha."""
        return self.format == "psd"


@dataclass(frozen=True, slots=True)
class Failure:
    """Files that could not be made, by their frames, and why in one sentence."""

    frames: tuple[int, ...]
    message: Message


@dataclass(frozen=True, slots=True)
class Summary:
    """What came of an export.

    Parameters
    ----------
    files
        How many files were asked for: frames times layers, and composites.
    written
        How many of them are new.
    drawn
        How many different pictures that took.
    trusted
        How many were whole already and left alone.
    failures
        What could not be made.
    cancelled
        Whether it was stopped before the end; every file that is there is whole.
    folders
        The folders that hold the files, absolute.
    names
        Layer name → the name its folder and files carry.
    seconds
        How long it took.
    notes
        What the user should know, one sentence each.
    counts
        The files by what they are.
    made
        The files that are there, in the order of their pictures.
    """

    files: int
    written: int
    drawn: int
    trusted: int
    failures: tuple[Failure, ...]
    cancelled: bool
    folders: tuple[Path, ...]
    names: dict[str, str]
    seconds: float
    notes: tuple[Message, ...] = ()
    counts: tuple["FileCount", ...] = ()
    made: tuple["MadeFile", ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether everything asked for is there."""
        return not self.failures and not self.cancelled


Progress = Callable[[int, int], None]
"""Called with the steps done so far and all there are, on the thread that asked for the export.

A step is a file: made, copied, or found to be whole already. Nothing is left to do when all are done.
"""

Cancelled = Callable[[], bool]
"""Asked between pictures whether to stop."""
