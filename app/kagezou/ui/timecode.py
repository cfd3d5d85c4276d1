"""Frames as animators write them: ``84``, ``3+12`` (seconds and frames), ``3:12``, and ``+6`` / ``-6`` from here."""

import re
from fractions import Fraction

from kagezou.errors import UsageProblem

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
    raise UsageProblem(f"{typed[:30]!r} is not a frame; type 84, 3+12, 3:12 or +6")
