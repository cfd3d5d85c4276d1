"""Frames as animators write them: ``84``, ``3+12`` (seconds and frames), ``3:12``, and ``+6`` / ``-6`` from here."""

import re
from enum import StrEnum
from fractions import Fraction

from kagezou.errors import UsageProblem
from kagezou.message import Message

_FRAME = re.compile(r"(\d{1,7})")
_OFFSET = re.compile(r"([+-])\s*(\d{1,7})")
_SECONDS = re.compile(r"(\d{1,5})\s*[+:]\s*(\d{1,3})")


def frames_per_second(rate: Fraction) -> int:
    """Return the whole number of frames a sheet counts in a second: 24 for 23.976."""
    return max(round(rate), 1)


def sheet_text(frame: int, rate: Fraction) -> str:
    """Return the length up to and including a frame as seconds + frames; frame 84 at 24 a second is ``3+12``."""
    seconds, rest = divmod(frame, frames_per_second(rate))
    return f"{seconds}+{rest:02d}"


class Count(StrEnum):
    """How a ruler counts frames."""

    FRAMES = "frames"
    SECONDS = "seconds"
    """``3+12``: seconds and frames."""
    SHEET_6 = "sheet6"
    """Frames of a timesheet's page of six seconds."""
    SHEET_3 = "sheet3"
    TIMECODE = "timecode"


_PAGE_S = {Count.SHEET_6: 6, Count.SHEET_3: 3}


def counted(frame: int, rate: Fraction, count: Count) -> str:
    """Return how a ruler writes a frame; a page's first frame also names the page, as ``p2``."""
    a_second = frames_per_second(rate)
    match count:
        case Count.FRAMES:
            return str(frame)
        case Count.SECONDS:
            return sheet_text(frame - 1, rate)
        case Count.TIMECODE:
            seconds, rest = divmod(frame - 1, a_second)
            return f"{seconds // 60:02d}:{seconds % 60:02d}:{rest:02d}"
        case _:
            page, rest = divmod(frame - 1, a_second * _PAGE_S[count])
            return f"p{page + 1}" if rest == 0 else str(rest + 1)


def parse_frame(text: str, current: int, rate: Fraction) -> int:
    """Return the frame a text names, counted from ``current`` where it begins with a sign.

    Raises
    ------
    UsageProblem
        If the text is none of the forms.
    """
    typed = text.strip()
    if found := _FRAME.fullmatch(typed):
        return int(found[1])
    if found := _OFFSET.fullmatch(typed):
        return current + int(found[1] + found[2])
    if found := _SECONDS.fullmatch(typed):
        return int(found[1]) * frames_per_second(rate) + int(found[2])
    raise UsageProblem(Message("{typed!r} is not a frame; type 84, 3+12, 3:12 or +6", typed=typed[:30]))
