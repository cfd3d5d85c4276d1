"""What is said of a whole cut by words: ``canvas.size`` and the like, as the command line takes and lists them."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from kagezou.animation.timecode import parse_rate
from kagezou.document.cut_settings import CutSettings
from kagezou.errors import UsageProblem
from kagezou.message import Message

_SIZE: Final = re.compile(r"(\d{1,6})\s*[xX×]\s*(\d{1,6})")
Said = str | int
"""A word or a whole number."""


@dataclass(frozen=True, slots=True)
class CutWord:
    """One setting of a cut.

    Parameters
    ----------
    path, help
        What people write for it, and what it does.
    value
        What a cut has.
    usual
        What a cut has of which nothing is said.
    put
        Returns settings with another value of a text; UsageProblem for one that cannot be.
    """

    path: str
    help: Message
    value: Callable[[CutSettings], Said]
    usual: Said
    put: Callable[[CutSettings, str], CutSettings]

    def said(self, settings: CutSettings, word: object) -> CutSettings:
        """Return settings in which it is another: a word, a number, or a pair of whole numbers for a size.

        Raises
        ------
        UsageProblem
            It cannot be that.
        """
        return self.put(settings, _text(self.path, word))


def cut_word_at(path: str) -> CutWord | None:
    """Return what a path names; None where it names something else."""
    return next((each for each in CUT_WORDS if each.path == path), None)


def _text(path: str, word: object) -> str:
    match word:
        case str():
            return word.strip()
        case bool():
            pass
        case int() | float():
            return f"{word:g}" if isinstance(word, float) else str(word)
        case [int(width), int(height)]:
            return f"{width}x{height}"
    raise UsageProblem(Message("{path} cannot be {word!r}", path=path, word=word))


def _sized(settings: CutSettings, text: str) -> CutSettings:
    found = _SIZE.fullmatch(text)
    if found is None:
        raise UsageProblem(Message("{text!r} is not a size such as 1920x1080", text=text[:30]))
    return replace(settings, canvas=replace(settings.canvas, width_px=int(found[1]), height_px=int(found[2])))


def _whole(path: str, text: str) -> int:
    if not re.fullmatch(r"\d{1,7}", text):
        raise UsageProblem(Message("{path}: {text!r} is not a whole number", path=path, text=text[:30]))
    return int(text)


CUT_WORDS: Final = (
    CutWord(
        "canvas.size",
        Message("Width and height of the picture in px; --drawings says what becomes of what is on it."),
        lambda now: f"{now.canvas.width_px}x{now.canvas.height_px}",
        "1920x1080",
        _sized,
    ),
    CutWord(
        "canvas.fps",
        Message("Frames a second: 24, 23.976, 24000/1001; keys and drawings stay on their frames."),
        lambda now: str(now.canvas.frame_rate),
        "24",
        lambda now, text: replace(now, canvas=replace(now.canvas, frame_rate=parse_rate(text))),
    ),
    CutWord(
        "canvas.length",
        Message("How many frames the cut has; what lies behind its end is kept."),
        lambda now: now.canvas.length_frames,
        1,
        lambda now, text: replace(now, canvas=replace(now.canvas, length_frames=_whole("canvas.length", text))),
    ),
    CutWord(
        "canvas.first_frame",
        Message("The number that the first frame bears in the window and in files; --frame and --frames count from 1."),
        lambda now: now.canvas.first_frame,
        1,
        lambda now, text: replace(now, canvas=replace(now.canvas, first_frame=_whole("canvas.first_frame", text))),
    ),
    CutWord(
        "canvas.name",
        Message("The name of the production or the episode."),
        lambda now: now.slate.name,
        "",
        lambda now, text: replace(now, slate=replace(now.slate, name=text)),
    ),
    CutWord(
        "canvas.scene",
        Message("The number of the scene, which may have letters."),
        lambda now: now.slate.scene,
        "",
        lambda now, text: replace(now, slate=replace(now.slate, scene=text)),
    ),
    CutWord(
        "canvas.cut",
        Message("The number of the cut, which may have letters; a timesheet that is written bears it."),
        lambda now: now.slate.cut,
        "",
        lambda now, text: replace(now, slate=replace(now.slate, cut=text)),
    ),
)
"""All of them, in the order in which they are listed."""
