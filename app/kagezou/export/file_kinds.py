"""What the files of an export are, in words, and how many of each kind there are."""

from collections.abc import Iterable
from dataclasses import dataclass
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
from kagezou.message import Message

MATTE_FRAMES: Final = Message("mattes")
DRAWINGS: Final = Message("copies of the drawings")
BACKGROUNDS: Final = Message("copies of the background")
SCRIPT: Final = Message("script")
VIDEO: Final = Message("video")
JOB_FILES: Final = Message("files of the job")
LAYER_PICTURES: Final = Message("pictures of layers")
SCENE: Final = Message("scene")

_OF_SUBJECTS: Final[dict[type[Subject], Message]] = {
    ShadowSubject: Message("shadow frames"),
    SetShadowSubject: Message("shadow frames of the set"),
    ClaySubject: Message("frames of sets as clay"),
    UnitedSubject: Message("united shadows"),
    TogetherSubject: Message("united shadows"),
    ReceivedSubject: Message("received shadows"),
    ContactSubject: Message("contacts"),
    ReflectionSubject: Message("reflections"),
    ReceiverSubject: MATTE_FRAMES,
    CompositeSubject: Message("composites"),
    LayeredSubject: Message("layered frames"),
}


@dataclass(frozen=True, slots=True)
class FileCount:
    """How many files of a kind were asked for, and how many of them are there, whole."""

    kind: Message
    there: int
    files: int


def kind_of(subject: Subject) -> Message:
    """Return what the files of a sequence are."""
    return _OF_SUBJECTS[type(subject)]


def added_up(counts: Iterable[FileCount]) -> tuple[FileCount, ...]:
    """Return one count for each kind, in the order in which the kinds appear."""
    found: dict[Message, FileCount] = {}
    for each in counts:
        before = found.get(each.kind, FileCount(each.kind, 0, 0))
        found[each.kind] = FileCount(each.kind, before.there + each.there, before.files + each.files)
    return tuple(each for each in found.values() if each.files)
