"""Frames as animators write them: ``84``, ``3+12`` (seconds and frames), ``3:12``, and ``+6`` / ``-6`` from here."""

import re
from enum import StrEnum
from fractions import Fraction

from kagezou.errors import UsageProblem
from kagezou.message import Message

_FRAME = re.compile(r"(\d{1,7})")
_OFFSET = re.compile(r"([+-])\s*(\d{1,7})")
_RATE = re.compile(r"\d{1,9}(?:[./]\d{1,9})?")
_BROADCAST = {"23.976": 24000, "23.98": 24000, "29.97": 30000, "47.952": 48000, "59.94": 60000, "119.88": 120000}
"""Frame rates that people round: so many thousand-and-firsts a second."""
MOST_A_SECOND = 1000
_SECONDS = re.compile(r"(\d{1,5})\s*[+:]\s*(\d{1,3})")


def frames_per_second(rate: Fraction) -> int:
    """Return the whole number of frames a sheet counts in a second: 24 for 23.976."""
    return max(round(rate), 1)


def parse_rate(text: str) -> Fraction:
    """Return frames a second: ``24``, ``12.5``, ``23.976`` (which is 24000/1001), ``24000/1001``.

    Raises
    ------
    UsageProblem
        If it is no number over 0 and up to 1000.
    """
    typed = text.strip()
    above = _BROADCAST.get(typed)
    if above is not None:
        return Fraction(above, 1001)
    is_rate = _RATE.fullmatch(typed) is not None and not re.search(r"/0+$", typed)
    rate = Fraction(typed) if is_rate else Fraction(0)
    if not 0 < rate <= MOST_A_SECOND:
        raise UsageProblem(
            Message("{typed!r} is not a number of frames a second such as 24 or 24000/1001", typed=typed[:30])
        )
    return rate


def rate_text(rate: Fraction) -> str:
    """Return frames a second as people write them: ``24``, ``23.976``, ``12.5``."""
    return f"{float(rate):.5g}"


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


def counted(frame: int, rate: Fraction, count: Count, first: int = 1) -> str:
    """Return how a ruler writes a frame; a page's first frame also names the page, as ``p2``.

    Numbers of frames count from ``first``, all other counts from the cut's beginning.
    """
    a_second = frames_per_second(rate)
    match count:
        case Count.FRAMES:
            return str(frame + first - 1)
        case Count.SECONDS:
            return sheet_text(frame - 1, rate)
        case Count.TIMECODE:
            seconds, rest = divmod(frame - 1, a_second)
            return f"{seconds // 60:02d}:{seconds % 60:02d}:{rest:02d}"
        case _:
            page, rest = divmod(frame - 1, a_second * _PAGE_S[count])
            return f"p{page + 1}" if rest == 0 else str(rest + 1)


def parse_frame(text: str, current: int, rate: Fraction, first: int = 1) -> int:
    """Return the frame a text names, counted from ``current`` where it begins with a sign.

    A number counts from ``first``, the number that the first frame bears; the frame that is returned counts from 1.

    Raises
    ------
    UsageProblem
        If the text is none of the forms.
    """
    typed = text.strip()
    if found := _FRAME.fullmatch(typed):
        return int(found[1]) - first + 1
    if found := _OFFSET.fullmatch(typed):
        return current + int(found[1] + found[2])
    if found := _SECONDS.fullmatch(typed):
        return int(found[1]) * frames_per_second(rate) + int(found[2])
    raise UsageProblem(Message("{typed!r} is not a frame; type 84, 3+12, 3:12 or +6", typed=typed[:30]))
