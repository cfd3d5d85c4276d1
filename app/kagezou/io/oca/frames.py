"""The frames of a layer of Open Cel Animation: which picture is seen from when on, and where it lies."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final

from kagezou.io.files.json_text import Reader
from kagezou.io.files.spellings import on_disk
from kagezou.io.oca.document import OcaFrame
from kagezou.io.sheets.xdts_values import text_of_value, whole
from kagezou.message import Message

_MAX_FRAMES: Final = 1_000_000
_BLANK: Final = "_blank"


@dataclass(slots=True)
class FrameReading:
    """What frames are read against.

    Parameters
    ----------
    path
        The document's file.
    start
        The number of its first frame.
    size_px
        Its canvas.
    notes
        What is to be said.
    is_faint
        Whether the layer that was read last is not opaque.
    """

    path: Path
    start: int
    size_px: tuple[int, int]
    notes: list[Message] = field(default_factory=list)
    is_faint: bool = False


def frames_of(layer: Mapping[str, Reader], name: str, reading: FrameReading) -> tuple[OcaFrame, ...]:
    """Return the frames of a layer in order, one a frame; between them nothing is seen where no frame lasts.

    Parameters
    ----------
    layer
        The members of the layer.
    name
        What it is called.
    reading
        The document; what is to be said is added to its notes.
    """
    own = layer.get("opacity")
    is_still = "animated" in layer and not layer["animated"].value
    found: dict[int, OcaFrame] = {}
    opacities: list[float] = []
    for reader in layer["frames"].items(_MAX_FRAMES) if "frames" in layer else ():
        frame = _frame(reader, layer, name, reading)
        if frame.frame in found:
            reading.notes.append(
                Message("{name}: two frames begin at {frame}; the later one is used", name=name, frame=frame.frame)
            )
        found[frame.frame] = frame
        opacities.append(_opacity(reader.members().get("opacity"), own))
    reading.is_faint = any(opacity < 1 for opacity in opacities)
    made = _from_first(found, name, reading)
    return (replace(made[0], frame=1, duration_frames=0),) if is_still and len(made) == 1 else tuple(made)


def _from_first(found: dict[int, OcaFrame], name: str, reading: FrameReading) -> list[OcaFrame]:
    """Return frames in order; one that begins before the document and lasts into it begins with it."""
    made: list[OcaFrame] = []
    before = False
    for frame in (found[number] for number in sorted(found)):
        left = frame.frame + frame.duration_frames - 1
        if frame.frame >= 1:
            made.append(frame)
        elif left >= 1:
            made.append(replace(frame, frame=1, duration_frames=left))
        else:
            before = True
    if before:
        reading.notes.append(Message("{name}: what is before the document's first frame is not used", name=name))
    return made


def _frame(reader: Reader, layer: Mapping[str, Reader], layer_name: str, reading: FrameReading) -> OcaFrame:
    members = reader.members()
    name = text_of_value(members.get("name"))
    number = whole(members["frameNumber"], -_MAX_FRAMES, _MAX_FRAMES) if "frameNumber" in members else reading.start
    duration = whole(members["duration"], 0, _MAX_FRAMES) if "duration" in members else 1
    listed = text_of_value(members.get("fileName"))
    is_blank = name == _BLANK or ("fileName" in members and not listed)
    size = (_side(members, layer, "width"), _side(members, layer, "height"))
    return OcaFrame(
        frame=number - reading.start + 1,
        duration_frames=max(duration, 1),
        name=name,
        file=None if is_blank else _file(listed or _usual_file(layer, layer_name, name), reading.path),
        middle_px=None if is_blank else _middle(members),
        size_px=(size[0], size[1]) if size[0] and size[1] else None,
    )


def _usual_file(layer: Mapping[str, Reader], layer_name: str, name: str) -> str:
    suffix = text_of_value(layer.get("fileType")).lstrip(".") or "png"
    return f"{layer_name}/{name}.{suffix}"


def _file(listed: str, document: Path) -> Path:
    """Return where a picture lies: from the document's folder, or from the one around it, as examples have it."""
    given = Path(listed.replace("\\", "/"))
    places = [document.parent / given, document.parent.parent / given, document.parent / given.name]
    there = (on_disk(each) for each in places)
    return next((each for each in there if each.is_file()), places[0])


def _middle(members: Mapping[str, Reader]) -> tuple[float, float] | None:
    if "position" not in members:
        return None
    x, y = (each.number(-1e9, 1e9) for each in members["position"].items(2, 2))
    return (x, y)


def _side(members: Mapping[str, Reader], layer: Mapping[str, Reader], name: str) -> int | None:
    reader = members.get(name, layer.get(name))
    return None if reader is None else whole(reader, 0, 1 << 20)


def _opacity(frame: Reader | None, layer: Reader | None) -> float:
    reader = frame or layer
    return 1.0 if reader is None else reader.number(0, 1e9)
