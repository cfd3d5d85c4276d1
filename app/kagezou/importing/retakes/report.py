"""What came of a retake: which drawing became which, and what a person should look at."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kagezou.animation.frames import format_frames
from kagezou.importing.retakes.matching import How
from kagezou.message import Message, first_names

_MOST_FRAMES: Final = 12
"""So many frames are named."""


@dataclass(frozen=True, slots=True)
class Row:
    """One drawing: the names of before and of now, None where it is new or gone, and by what it was known again."""

    before: str | None
    after: str | None
    how: How | None


@dataclass(frozen=True, slots=True)
class MovedContact:
    """A foot that stood elsewhere before: a frame of now, its drawing, and how far, as a part of the figure's height.

    ``away`` is None where it does not stand any more.
    """

    frame: int
    drawing: str
    away: float | None


@dataclass(frozen=True, slots=True)
class Report:
    """What came of a retake.

    Parameters
    ----------
    name
        The layer.
    rows
        Every drawing, in the order of now; those that are gone come last.
    contacts
        Those that moved by more than a hundredth of the height.
    frames
        Which frames to look at, upward.
    pins_kept, pins_dropped
        How many words about feet stayed, and on which drawings how many did not.
    keys_moved
        How many keys of the layer went along with their drawings.
    keys_dropped
        Those that came on the frame of another one, as ``property`` and frame of before.
    gone_frames
        Frames on which a drawing began that is gone and the one before is held.
    unseen
        New drawings that no timing shows.
    """

    name: str
    rows: tuple[Row, ...]
    contacts: tuple[MovedContact, ...] = ()
    frames: tuple[int, ...] = ()
    pins_kept: int = 0
    pins_dropped: tuple[tuple[str, int], ...] = ()
    keys_moved: int = 0
    keys_dropped: tuple[tuple[str, int], ...] = ()
    gone_frames: tuple[int, ...] = ()
    unseen: tuple[str, ...] = ()

    @property
    def is_to_be_read(self) -> bool:
        """Whether more changed than where the drawings lie."""
        return any(row.how is not How.SAME for row in self.rows) or bool(self.contacts or self.pins_dropped)

    @property
    def messages(self) -> tuple[Message, ...]:
        """The same in sentences, each once."""
        return (*_of_drawings(self), *_of_timing(self), *_of_feet(self))


def _of_drawings(report: Report) -> list[Message]:
    hows = Counter(row.how for row in report.rows if row.before is not None and row.after is not None)
    new = [row.after for row in report.rows if row.before is None and row.after is not None]
    gone = [row.before for row in report.rows if row.after is None and row.before is not None]
    said = [
        Message(
            "{name}: {same} drawings are as before, {changed} are other pictures, {new} are new, {gone} are gone",
            name=report.name,
            same=hows[How.SAME] + hows[How.PICTURE],
            changed=hows[How.NAME] + hows[How.LIKENESS] + hows[How.ORDER],
            new=len(new),
            gone=len(gone),
        )
    ]
    if hows[How.PICTURE] or hows[How.LIKENESS] or hows[How.ORDER]:
        said.append(
            Message(
                "{name}: known again under another name: {picture} by the same picture, {likeness} by likeness, "
                "{order} by their order",
                name=report.name,
                picture=hows[How.PICTURE],
                likeness=hows[How.LIKENESS],
                order=hows[How.ORDER],
            )
        )
    if new:
        said.append(Message("{name}: new drawings: {names}", name=report.name, names=first_names(new)))
    if gone:
        said.append(Message("{name}: drawings that are gone: {names}", name=report.name, names=first_names(gone)))
    return said


def _of_timing(report: Report) -> list[Message]:
    said = []
    if report.gone_frames:
        said.append(
            Message(
                "{name}: where a drawing is gone the one before is held (frames {frames})",
                name=report.name,
                frames=named_frames(report.gone_frames),
            )
        )
    if report.unseen:
        said.append(
            Message("{name}: no timing shows these: {names}", name=report.name, names=first_names(report.unseen))
        )
    if report.keys_moved:
        said.append(
            Message("{name}: {count} keys went along with their drawings", name=report.name, count=report.keys_moved)
        )
    if report.keys_dropped:
        lost = first_names(f"{prop} {frame}" for prop, frame in report.keys_dropped)
        said.append(
            Message("{name}: keys that came upon another key and are left out: {keys}", name=report.name, keys=lost)
        )
    return said


def _of_feet(report: Report) -> list[Message]:
    said = []
    if report.pins_dropped:
        names = first_names(f"{drawing} ({count})" for drawing, count in report.pins_dropped)
        said.append(
            Message("{name}: words about feet that are not there any more: {names}", name=report.name, names=names)
        )
    if report.contacts:
        frames = named_frames(sorted({each.frame for each in report.contacts}))
        said.append(
            Message(
                "{name}: contacts that moved by more than 1 % of the height: frames {frames}",
                name=report.name,
                frames=frames,
            )
        )
    if report.frames:
        said.append(
            Message("{name}: please look at frames {frames}", name=report.name, frames=named_frames(report.frames))
        )
    return said


def named_frames(frames: Sequence[int]) -> str:
    """Return the first frames in words."""
    return format_frames(frames[:_MOST_FRAMES]) + (", …" if len(frames) > _MOST_FRAMES else "")
