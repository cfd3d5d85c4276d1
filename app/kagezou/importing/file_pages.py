"""Files of several pictures, which are the drawings of one character: films by their durations, pages on ones."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import accumulate
from pathlib import Path
from typing import Final

from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.io.files.faults import shown
from kagezou.io.images.opening import durations_ms
from kagezou.io.images.reading import probe
from kagezou.io.pixels.signatures import FORMATS
from kagezou.message import Message

FILM_RATE: Final = Fraction(24)
"""Frames a second where nobody says any."""

_MOST_PICTURES: Final = 1000
_UNSAID_MS: Final = 100.0
"""How long programs show a picture of a film that does not say it."""

_PAGED: Final = frozenset({"tiff"})


@dataclass(frozen=True, slots=True)
class FilePages:
    """The pictures of a file.

    Parameters
    ----------
    cels
        One drawing a picture, named by its number, and its exposure.
    length_frames
        Up to the end of the last.
    notes
        How they were taken.
    """

    cels: Cels
    length_frames: int
    notes: tuple[Message, ...]


def pages_of(path: Path, frame_rate: Fraction) -> FilePages | None:
    """Return the pictures of a file that has several, None for any other.

    Parameters
    ----------
    path
        The file.
    frame_rate
        Frames a second of the cut.

    Raises
    ------
    InputProblem
        It cannot be read.
    """
    form = FORMATS.get(path.suffix.lower())
    if form not in {"png", "webp", "gif", *_PAGED}:
        return None
    count = min(probe(path).pictures, _MOST_PICTURES)
    if count < 2:
        return None
    drawings = tuple(Drawing(str(number), path, str(number)) for number in range(1, count + 1))
    if form in _PAGED:
        ones = tuple(Exposure(index + 1, index) for index in range(count))
        note = Message("{path}: its {count} pages are its drawings, a frame each", path=shown(path), count=count)
        return FilePages(Cels(drawings, ones), count, (note,))
    said = durations_ms(path)[:count]
    frames = exposed_frames([each or _UNSAID_MS for each in said], frame_rate)
    exposures = tuple(Exposure(frame, index) for index, frame in enumerate(frames[:-1]))
    return FilePages(Cels(drawings, exposures), frames[-1] - 1, _notes(path, said, frames, frame_rate))


def exposed_frames(durations: Sequence[float], frame_rate: Fraction) -> tuple[int, ...]:
    """Return the frame on which each picture of a film comes to be seen, from 1, and that after its end.

    Parameters
    ----------
    durations
        How long each is seen, ms.
    frame_rate
        Frames a second; times are rounded, and every picture is seen for a frame at least.
    """
    frames = [1]
    for end in accumulate(durations):
        frames.append(max(round(end * float(frame_rate) / 1000) + 1, frames[-1] + 1))
    return tuple(frames)


def _notes(path: Path, said: Sequence[float], frames: Sequence[int], frame_rate: Fraction) -> tuple[Message, ...]:
    rate = f"{float(frame_rate):g}"
    count = len(said)
    exact = [1 + end * float(frame_rate) / 1000 for end in accumulate(said)]
    if not all(said):
        head = Message(
            "{path}: its {count} pictures are its drawings; {unsaid} of them do not say how long they are seen, "
            "which counts as {ms:g} ms",
            path=shown(path),
            count=count,
            unsaid=sum(not each for each in said),
            ms=_UNSAID_MS,
        )
    elif all(abs(frame - time) < 0.05 for frame, time in zip(frames[1:], exact, strict=True)):
        head = Message(
            "{path}: its {count} pictures are its drawings, as long as it says at {rate} frames/s",
            path=shown(path),
            count=count,
            rate=rate,
        )
    else:
        head = Message(
            "{path}: its {count} pictures are its drawings, as long as it says, rounded to whole frames at {rate} "
            "frames/s",
            path=shown(path),
            count=count,
            rate=rate,
        )
    return (head,)
