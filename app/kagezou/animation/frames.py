"""Frame ranges as people type them: ``1-48``, ``3``, ``1-10,20``, ``1-48x2``; and frames that stand for a cut."""

import re
from collections.abc import Iterable

from kagezou.errors import UsageProblem
from kagezou.message import Message

_PART = re.compile(r"(\d+)(?:-(\d+)(?:x(\d+))?)?")
MAX_FRAMES = 1_000_000


def parse_frames(text: str) -> tuple[int, ...]:
    """Return the frames that ``text`` names, in order and without repeats; both ends of a range are included.

    Raises
    ------
    UsageProblem
        If the text is not a list of frames and ranges counted from 1.
    """
    frames: set[int] = set()
    for part in text.split(","):
        found = _PART.fullmatch(part.strip())
        if found is None:
            raise UsageProblem(
                Message(
                    "frames {text!r}: {part!r} is neither a frame such as 12 nor a range such as 1-48",
                    text=text,
                    part=part.strip(),
                )
            )
        first = int(found[1])
        last = int(found[2] or first)
        if first < 1 or last < first or last > MAX_FRAMES:
            raise UsageProblem(
                Message("frames {text!r}: {part!r} must count upward from frame 1", text=text, part=part.strip())
            )
        frames.update(range(first, last + 1, max(int(found[3] or 1), 1)))
    return tuple(sorted(frames))


def format_frames(frames: Iterable[int]) -> str:
    """Return frames as the shortest text that :func:`parse_frames` reads back."""
    parts: list[str] = []
    run: list[int] = []
    for frame in [*sorted(set(frames)), None]:
        if run and (frame is None or frame != run[-1] + 1):
            parts.append(str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}")
            run = []
        if frame is not None:
            run.append(frame)
    return ",".join(parts)


def spread_frames(length_frames: int, most: int) -> tuple[int, ...]:
    """Return at most so many frames, evenly spread over a cut, from its first frame to its last.

    Parameters
    ----------
    length_frames
        The last frame, at least 1.
    most
        At least 2.
    """
    count = min(length_frames, most)
    return tuple(1 + round(each * (length_frames - 1) / max(count - 1, 1)) for each in range(count))
