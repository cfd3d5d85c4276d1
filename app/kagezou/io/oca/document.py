"""A document of Open Cel Animation, as values: what of it can be used, and what is said of the rest."""

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class OcaFrame:
    """A picture, or none, from a frame on.

    Parameters
    ----------
    frame
        The first frame that shows it, from 1.
    duration_frames
        For how many frames it is seen; 0 for the whole document.
    name
        What it is called.
    file
        Its picture; None for an empty frame.
    middle_px
        Where its middle lies on the canvas, px, y down; None where nothing is said, which is the canvas's middle.
    size_px
        Width and height that the document says; None where it says none.
    """

    frame: int
    duration_frames: int
    name: str
    file: Path | None
    middle_px: tuple[float, float] | None = None
    size_px: tuple[int, int] | None = None


@dataclass(frozen=True, slots=True)
class OcaLayer:
    """A layer of pictures that lies plainly on those below it.

    Parameters
    ----------
    name
        What it is called.
    group
        The names of the groups it is in, the outermost first.
    frames
        In order, one a frame.
    """

    name: str
    group: tuple[str, ...]
    frames: tuple[OcaFrame, ...]


@dataclass(frozen=True, slots=True)
class OcaDocument:
    """A document.

    Parameters
    ----------
    name
        What it is called; empty where it says nothing.
    frame_rate
        Frames a second.
    size_px
        Width and height of the canvas.
    length_frames
        How long it is.
    layers
        From the bottom.
    counts_from_corner
        Whether a middle is a whole pixel between the first and the last, as Krita has it, rounded towards 0.
    notes
        What of the file is not used and what had to be assumed, without the file's name.
    """

    name: str
    frame_rate: Fraction
    size_px: tuple[int, int]
    length_frames: int
    layers: tuple[OcaLayer, ...]
    counts_from_corner: bool = False
    notes: tuple[Message, ...] = ()
