"""The files that an export left, one by one: what each shows, of whom, on which frame, and its hash."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.export.subjects import (
    ClaySubject,
    CompositeSubject,
    ContactSubject,
    LayeredSubject,
    ReceivedSubject,
    ReceiverSubject,
    ReflectionSubject,
    SetShadowSubject,
    ShadowSubject,
    Subject,
    TogetherSubject,
    UnitedSubject,
)

DRAWING: Final = "drawing"
BACKGROUND: Final = "background"
SCRIPT: Final = "script"
SCENE: Final = "scene"
PICTURE: Final = "picture"
VIDEO: Final = "video"
JOB: Final = "job"
MATTE: Final = "matte"
"""Words for programs, which no other version says otherwise."""

_OF_SUBJECTS: Final[dict[type[Subject], str]] = {
    ShadowSubject: "shadow",
    SetShadowSubject: "set shadow",
    ClaySubject: "clay",
    UnitedSubject: "united shadow",
    TogetherSubject: "united shadow",
    ReceivedSubject: "received shadow",
    ContactSubject: "contact",
    ReflectionSubject: "reflection",
    ReceiverSubject: MATTE,
    CompositeSubject: "composite",
    LayeredSubject: "layered",
}
_NUMBERED: Final = re.compile(r"(.*_)(\d+)")


@dataclass(frozen=True, slots=True)
class MadeFile:
    """One file that is there, whole.

    Parameters
    ----------
    path
        Absolute.
    kind
        What it is, as a word for programs.
    sequence
        The name of the numbered files that it is one of; empty for a file of its own.
    owner
        The id of the layer or set piece that it is of; of what is of neither, any other text.
    frames
        The first frame that it is for, from 1; nothing where it is for the whole cut or a number of its own.
    sha256
        The hash of its bytes, hexadecimal; empty where nobody has made it yet.
    is_new
        Whether this export wrote it; else it was whole already.
    """

    path: Path
    kind: str
    sequence: str = ""
    owner: str = ""
    frames: tuple[int, ...] = ()
    sha256: str = ""
    is_new: bool = True


def word_of(subject: Subject) -> str:
    """Return what the files of a sequence are, as a word for programs."""
    return _OF_SUBJECTS[type(subject)]


def numbered_from(first: Path, count: int) -> Iterator[Path]:
    """Yield the files of a sequence without gaps; a file whose name has no number is alone."""
    found = _NUMBERED.fullmatch(first.stem)
    if found is None or count < 2:
        yield first
        return
    start, digits = int(found[2]), len(found[2])
    for number in range(start, start + count):
        yield first.with_name(f"{found[1]}{number:0{digits}d}{first.suffix}")
