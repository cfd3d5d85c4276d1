"""What a source brings before it is in a document: layers to be, and what is said about them."""

import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from kagezou.document.model import Cels
from kagezou.io.files.faults import shown
from kagezou.io.images.sequences import Sequence
from kagezou.message import Message, first_names
from kagezou.picture_source import PicturePart

MAX_NAME_CHARACTERS = 200


@dataclass(frozen=True, slots=True)
class CharacterSource:
    """A character someone brings: a folder, a picture, a PSD file or a pattern ``walk_#.png``, and perhaps its name.

    Where a timesheet says when each drawing is seen, numbers that no file has are nothing to speak of. A source that
    joins a character is a part of its figure: an arm, a held thing. ``layer`` is what is taken of its OpenEXR files.
    Of a source with drawings these alone are meant.
    """

    name: str | None
    path: Path
    is_timed: bool = False
    joins: str | None = None
    layer: str | None = None
    drawings: Sequence | None = None


@dataclass(frozen=True, slots=True)
class NewCels:
    """The cels of a layer to be.

    Parameters
    ----------
    name
        What the layer is to be called.
    cels
        Its drawings, with absolute paths, and exposures.
    size_px
        The largest width and the largest height among its drawings.
    length_frames
        Up to the last exposure; 1 for a still.
    notes
        What is odd about the files, one sentence each.
    joins
        The name of the layer whose figure it is a part of; None for a figure of its own.
    moved
        ``(frame, (dx, dy))``, px: from when on its drawings lie so far from the middle of the canvas.
    """

    name: str
    cels: Cels
    size_px: tuple[int, int]
    length_frames: int
    notes: tuple[Message, ...]
    joins: str | None = None
    moved: tuple[tuple[int, tuple[int, int]], ...] = ()


@dataclass(frozen=True, slots=True)
class Held:
    """What a source holds.

    Parameters
    ----------
    layers
        From the lowest up.
    notes
        About the source as a whole.
    backgrounds
        Opaque pictures in it that are named like a background, or fill the canvas under everything.
    away_px
        How far from the middle of the canvas the first of them lies.
    """

    layers: list[NewCels]
    notes: list[Message]
    backgrounds: tuple[PicturePart | Path, ...] = ()
    away_px: tuple[int, int] = (0, 0)


def printable(name: str) -> str:
    """Return a file's or folder's name as one that a layer may have."""
    composed = unicodedata.normalize("NFC", name)
    text = "".join(character if character.isprintable() else "_" for character in composed).strip()
    return text[:MAX_NAME_CHARACTERS] or "Character"


def left_out_note(path: Path, names: Iterable[str]) -> Message:
    """Return what is said about files or layers without a number."""
    return Message("{path}: left out, as they have no number: {names}", path=shown(path), names=first_names(names))
