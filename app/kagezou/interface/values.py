"""What scripts give and get: paths, values of properties, keys, and who is told how far something is."""

import os
from collections.abc import Callable, Iterable
from fractions import Fraction
from operator import index
from pathlib import Path
from typing import NamedTuple, TypeAlias

from kagezou.animation.frames import parse_frames
from kagezou.animation.timecode import parse_rate
from kagezou.animation.track import Value
from kagezou.document.value_words import NotJson, value_of_text
from kagezou.errors import UsageProblem
from kagezou.message import Message

AnyPath: TypeAlias = str | os.PathLike[str]
"""A file or a folder."""

FrameChoice: TypeAlias = str | Iterable[int] | None
"""Frames from 1: words such as ``"1-48"`` or ``"3,7,10-20"``, numbers, or None for the whole cut."""

ProgressCallback: TypeAlias = Callable[[int, int], None]
"""Called with the steps that are done and all there are, on the thread that asked for the work."""

StopCallback: TypeAlias = Callable[[], bool]
"""Asked between pictures, on the thread that asked for the work; true ends it. What is written is whole and stays."""


class PropertyKey(NamedTuple):
    """A key of a property.

    Attributes
    ----------
    frame
        Counted from 1.
    value
        On that frame.
    interpolation
        How it goes on from there: ``"hold"``, ``"linear"`` or ``"bezier"``.
    """

    frame: int
    value: Value
    interpolation: str


def no_progress(_done: int, _all: int) -> None:
    """Look away."""


def never() -> bool:
    """Return False: nothing stops the work."""
    return False


def path_of(given: AnyPath) -> Path:
    """Return a path."""
    return Path(os.fspath(given))


def frames_of(given: FrameChoice) -> tuple[int, ...] | None:
    """Return frames upward; None for the whole cut.

    Raises
    ------
    UsageProblem
        The words or numbers name no frames.
    """
    if given is None:
        return None
    return parse_frames(given) if isinstance(given, str) else tuple(sorted({whole(each) for each in given}))


def whole(frame: object) -> int:
    """Return a frame that a script gave, of whatever kind of whole number.

    Raises
    ------
    UsageProblem
        It is none.
    """
    try:
        return index(frame)  # type: ignore[arg-type] # which is to be found out
    except TypeError as error:
        raise UsageProblem(Message("{frame!r} is no frame: frames are whole numbers from 1", frame=frame)) from error


def rate_of(given: str | float | Fraction | None) -> Fraction | None:
    """Return frames a second: a number, or words such as ``"23.976"`` or ``"24000/1001"``.

    Raises
    ------
    UsageProblem
        It is no frame rate.
    """
    return None if given is None else parse_rate(str(given))


def raw_of(path: str, given: object) -> object:
    """Return a value that a script gave as properties take it; a text is read as the command line reads it."""
    if isinstance(given, str):
        try:
            return value_of_text(path, given)
        except NotJson:
            return given
    to_list = getattr(given, "tolist", None)  # An array, or a number of one.
    if to_list is not None:
        return to_list()
    return [raw_of(path, each) for each in given] if isinstance(given, list | tuple) else given
