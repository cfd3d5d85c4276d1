"""Reading documents of Open Cel Animation 1.x, as their specification has it and as programs write them."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import Final

from kagezou.animation.timecode import parse_rate
from kagezou.errors import ProjectProblem, UsageProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.files.json_text import Reader
from kagezou.io.oca.document import OcaDocument, OcaLayer
from kagezou.io.oca.frames import FrameReading, frames_of
from kagezou.io.sheets.sheet_text import json_in, text_of
from kagezou.io.sheets.xdts_values import text_of_value, whole
from kagezou.message import Message, first_names

SUFFIX: Final = ".oca"
MAX_BYTES: Final = 64 << 20
MAX_LAYERS: Final = 1000
_MAX_DEPTH: Final = 50
_MAX_SIDE: Final = 1 << 20
_MAX_TIME: Final = 1_000_000
_USUAL: Final = {"width": 1920, "height": 1080, "startTime": 0, "endTime": 240}
_USUAL_RATE: Final = Fraction(24)
_PICTURES: Final = ("paintlayer", "")


def oca_file(path: Path) -> Path | None:
    """Return the file of a document: ``path`` itself, or the one in a folder ``NAME.oca``; None where it is none.

    A folder that the system does not open is none: whoever takes it for one of drawings says why it cannot be read.
    """
    if path.suffix.lower() != SUFFIX:
        return None
    if not path.is_dir():
        return path
    try:
        there = sorted(path.iterdir())
    except OSError:
        return None
    inside = [each for each in there if each.suffix.lower() in (SUFFIX, ".json") and each.is_file()]
    alike = [each for each in inside if each.stem == path.stem]
    documents = [each for each in inside if each.suffix.lower() == SUFFIX]
    return next(iter((*alike, *documents, *inside)), None)


def read_oca(path: Path) -> OcaDocument:
    """Return the document at ``path``.

    Raises
    ------
    InputProblem
        It cannot be read or is none: one sentence with the place of what is wrong.
    """
    try:
        with path.open("rb") as stream:
            data = stream.read(MAX_BYTES + 1)
        if len(data) > MAX_BYTES:
            raise input_problem(path, Message("it is larger than {megabytes} MB", megabytes=MAX_BYTES >> 20))
        text, about_text = text_of(data)
        value, about_end = json_in(text)
        return _DocumentReading(path, [*about_text, *about_end]).document(Reader(value))
    except OSError as error:
        raise input_problem(path, error) from error
    except ProjectProblem as problem:
        raise input_problem(path, problem.message) from problem


@dataclass(slots=True)
class _DocumentReading:
    """A document under way: what was found, and what is to be said."""

    path: Path
    notes: list[Message]
    layers: list[OcaLayer] = field(default_factory=list)
    left: dict[str, list[str]] = field(default_factory=dict)
    faint: list[str] = field(default_factory=list)
    last_frame: int = 0

    def document(self, root: Reader) -> OcaDocument:
        """Return the whole document."""
        members = root.members()
        if "layers" not in members:
            raise root.problem(Message("the key {name!r} is missing", name="layers"))
        size = (self._number(members, "width", 1, _MAX_SIDE), self._number(members, "height", 1, _MAX_SIDE))
        start = self._number(members, "startTime", -_MAX_TIME, _MAX_TIME)
        end = self._number(members, "endTime", start, _MAX_TIME + start)
        reading = FrameReading(self.path, start, size)
        for layer in members["layers"].items(MAX_LAYERS):
            self._take(layer, (), reading, 0)
        self.notes += reading.notes
        self._tell(members)
        # Writers take the end for the last frame, or for the first behind it; what is drawn there decides.
        length = max(end - start, 1)
        length += self.last_frame == length + 1
        return OcaDocument(
            name=text_of_value(members.get("name")),
            frame_rate=self._rate(members.get("frameRate")),
            size_px=size,
            length_frames=length,
            layers=tuple(self.layers),
            counts_from_corner=text_of_value(members.get("originApp")).casefold().startswith("krita"),
            notes=tuple(dict.fromkeys(self.notes)),
        )

    def _take(self, reader: Reader, group: tuple[str, ...], reading: FrameReading, depth: int) -> None:
        """Take a layer, or those of a group."""
        members = reader.members()
        name = text_of_value(members.get("name")) or f"Layer {len(self.layers) + 1}"
        kind = text_of_value(members.get("type"))
        if not self._is_usable(members, "/".join((*group, name))):
            return
        if kind == "grouplayer":
            if depth == _MAX_DEPTH:
                raise reader.problem(Message("it is nested too deep"))
            for child in members["childLayers"].items(MAX_LAYERS) if "childLayers" in members else ():
                self._take(child, (*group, name), reading, depth + 1)
            return
        if kind not in _PICTURES:
            self.left.setdefault("kind", []).append(f"{name} ({kind})")
            return
        frames = frames_of(members, name, reading)
        if not any(frame.file for frame in frames):
            self.left.setdefault("empty", []).append("/".join((*group, name)))
            return
        self.last_frame = max(self.last_frame, *(each.frame + each.duration_frames - 1 for each in frames))
        if reading.is_faint:
            self.faint.append(name)
        self.layers.append(OcaLayer(name, group, frames))

    def _is_usable(self, members: dict[str, Reader], name: str) -> bool:
        """Return whether a layer is a drawing that is seen; what is not is told at the end."""
        blend = text_of_value(members.get("blendingMode")) or "normal"
        reasons = {
            "hidden": _is_set(members, "visible", usual=True) is False,
            "guide": _is_set(members, "reference"),
            "clipped": _is_set(members, "inheritAlpha"),
            "blend": blend != "normal" and not _is_set(members, "passThrough"),
        }
        why = next((reason for reason, holds in reasons.items() if holds), None)
        if why is not None:
            self.left.setdefault(why, []).append(f"{name} ({blend})" if why == "blend" else name)
        return why is None

    def _number(self, members: dict[str, Reader], name: str, low: int, high: int) -> int:
        """Return a whole number of the root; where it is missing, the usual one, which is said."""
        if name in members:
            return whole(members[name], low, high)
        usual = _USUAL[name]
        self.notes.append(Message("it does not say its {name}; {usual} was taken", name=name, usual=usual))
        return usual

    def _rate(self, reader: Reader | None) -> Fraction:
        if reader is None:
            self.notes.append(
                Message("it does not say its {name}; {usual} was taken", name="frameRate", usual=_USUAL_RATE)
            )
            return _USUAL_RATE
        number = reader.number(0, 1000)
        try:
            return parse_rate(f"{round(number, 3):g}")
        except UsageProblem as problem:
            raise reader.problem(problem.message) from problem

    def _tell(self, members: dict[str, Reader]) -> None:
        """Say what was left out, and why."""
        self.notes += _left_notes(self.left)
        if self.faint:
            self.notes.append(
                Message("the opacity of these layers is not used: {names}", names=first_names(self.faint))
            )
        colour = members.get("backgroundColor")
        if colour is not None and any(each.number(-1e9, 1e9) for each in list(colour.items(4))[3:]):
            self.notes.append(Message("its background colour is not used"))


def _is_set(members: dict[str, Reader], name: str, *, usual: bool = False) -> bool:
    """Return a switch, which some writers write as a number."""
    value = members[name].value if name in members else usual
    return bool(value) if isinstance(value, (bool, int)) else usual


def _left_notes(left: dict[str, list[str]]) -> Iterator[Message]:
    """Yield what is said about layers that were left out, by the reason."""
    for why, names in left.items():
        listed = first_names(names)
        match why:
            case "hidden":
                yield Message("left out, as they are hidden: {names}", names=listed)
            case "guide":
                yield Message("left out, as they are guides: {names}", names=listed)
            case "clipped":
                yield Message("left out, as they are cut to what is below them: {names}", names=listed)
            case "blend":
                yield Message("left out, as they do not lie plainly on what is below them: {names}", names=listed)
            case "empty":
                yield Message("left out, as they are empty: {names}", names=listed)
            case _:
                yield Message("left out, as they are of a kind that is not read: {names}", names=listed)
