"""A timesheet, whatever file it comes from: its cel columns and which cel is exposed from which frame on."""

from dataclasses import dataclass, field

from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class SheetTrack:
    """One cel column.

    Parameters
    ----------
    name
        As the sheet has it, trimmed; other columns may have the same.
    entries
        ``(frame, cel)`` in order, one a frame, the frame counted from 0: from there on this cel is seen, or none.
    """

    name: str
    entries: tuple[tuple[int, str | None], ...]


@dataclass(frozen=True, slots=True)
class SheetMark:
    """What is said or done in a cut beside its cels: a line of dialogue or a camera's move.

    Parameters
    ----------
    frame
        The first frame of it, counted from 0.
    length_frames
        For how many frames it goes on, at least 1.
    text
        As it is read.
    """

    frame: int
    length_frames: int
    text: str


@dataclass(frozen=True, slots=True)
class Timesheet:
    """A sheet of a file: its name, its length, its cel columns from the lowest to the topmost.

    ``notes`` say what of the file is not used and what had to be assumed, without the file's name. ``kept`` is what the
    file says of this sheet, as JSON text, so that a sheet that is written has what is not used here; it is no part of
    what makes two sheets equal. ``scene`` and ``cut`` are the numbers of its head; empty where nothing is said.
    ``marks`` is what its columns of dialogue and camera work say, in the order of frames.
    """

    name: str
    length_frames: int
    tracks: tuple[SheetTrack, ...]
    notes: tuple[Message, ...] = ()
    kept: str = field(default="", compare=False, repr=False)
    scene: str = field(default="", compare=False)
    cut: str = field(default="", compare=False)
    marks: tuple[SheetMark, ...] = field(default=(), compare=False)
