"""What a PSD file consists of: its header, and its groups and layers as plain values."""

import struct
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.pixels.signatures import LARGEST_SIDE_PX, checked_format
from kagezou.message import Message

LARGEST_FILE_BYTES: Final = 2 << 30
"""The largest PSD file that is read; it is held in memory while its layers are wanted."""

LARGEST_CANVAS_PX: Final = 64 << 20
"""So many pixels may a canvas have; layers are put together in floats of several times that size."""

DEEPEST: Final = 60
"""So deep may groups be nested."""

_HEAD: Final = struct.Struct(">4sH6xHIIHH")
_COLOUR_CHANNELS: Final = {0: 1, 1: 1, 2: 1, 3: 3, 4: 4, 7: 64, 8: 1, 9: 3}
"""Of bitmap, gray, indexed, RGB, CMYK, multichannel, duotone and Lab files."""


@dataclass(frozen=True, slots=True)
class PsdHeader:
    """The first bytes of a PSD file."""

    width_px: int
    height_px: int
    channels: int
    bit_depth: int
    mode: int

    @property
    def has_spare_channel(self) -> bool:
        """Whether there is a channel beyond the colours, which may be an alpha."""
        return self.channels > _COLOUR_CHANNELS[self.mode]


@dataclass(frozen=True, slots=True)
class PsdNode:
    """A layer, or a group with what is in it.

    Parameters
    ----------
    name
        As it is shown in the drawing program.
    address
        By what it is found again in the file.
    is_visible
        Its own eye; groups around it may be hidden.
    children
        From the lowest up; None for a layer.
    is_clipped
        Whether it is seen only where the layer below it is, and belongs to that.
    is_empty
        Whether there are no pixels in it.
    undrawn
        Effects and fills of its own, and of what is clipped to it, that will not be seen, by their names.
    blend
        How it is laid on what lies below it, such as ``multiply``; empty for simply over it.
    is_adjustment
        Whether it only changes the colours of what lies below it.
    """

    name: str
    address: str
    is_visible: bool = True
    children: tuple["PsdNode", ...] | None = None
    is_clipped: bool = False
    is_empty: bool = False
    undrawn: tuple[str, ...] = ()
    blend: str = ""
    is_adjustment: bool = False

    def below(self) -> Iterator["PsdNode"]:
        """Yield everything in it."""
        for child in self.children or ():
            yield child
            yield from child.below()


@dataclass(frozen=True, slots=True)
class PsdTree:
    """A whole PSD file: its canvas, px, and its layers from the lowest up; none where it is flattened."""

    width_px: int
    height_px: int
    layers: tuple[PsdNode, ...]


def psd_header(path: Path) -> PsdHeader:
    """Return what the first bytes of the file at ``path`` say.

    Raises
    ------
    InputProblem
        It is no PSD file, or one that claims more than can be read.
    """
    checked_format(path, whole=False)
    try:
        size = path.stat().st_size
        with path.open("rb") as stream:
            head = stream.read(_HEAD.size)
    except OSError as error:
        raise input_problem(path, error) from error
    if len(head) < _HEAD.size:
        raise input_problem(path, Message("the file is cut short"))
    _, version, channels, height, width, depth, mode = _HEAD.unpack(head)
    if version not in {1, 2} or depth not in {1, 8, 16, 32} or mode not in _COLOUR_CHANNELS or not 1 <= channels <= 56:
        raise input_problem(path, Message("the file is damaged (an impossible header)"))
    if not min(width, height):
        raise input_problem(path, Message("it has no pixels"))
    if max(width, height) > LARGEST_SIDE_PX or width * height > LARGEST_CANVAS_PX:
        raise input_problem(
            path, Message("{width} × {height} px is larger than can be read", width=width, height=height)
        )
    if size > LARGEST_FILE_BYTES:
        raise input_problem(path, Message("with {megabytes} MB it is larger than can be read", megabytes=size >> 20))
    return PsdHeader(width, height, channels, depth, mode)


def with_clipped(nodes: Iterable[PsdNode]) -> tuple[PsdNode, ...]:
    """Return nodes that lie beside each other, each with what cannot be drawn of those that are clipped to it."""
    made: list[PsdNode] = []
    base = -1
    for node in nodes:
        made.append(node)
        if not node.is_clipped or base < 0:
            base = len(made) - 1
            continue
        lost = (each for part in (node, *node.below()) for each in part.undrawn)
        made[base] = replace(made[base], undrawn=tuple(dict.fromkeys((*made[base].undrawn, *lost))))
    return tuple(made)


def addressed(names: Sequence[str], parent: str | None = None) -> tuple[str, ...]:
    """Return the addresses of layers that lie beside each other, from the lowest up, in a group or in the file itself.

    An address is the names that lead to a layer, with slashes between them; of layers with one name, the second from
    below has ``#2`` behind it, and one without a name is ``%``, which no name is. So a drawing is found again when its
    file was saved anew, whatever came or went.
    """
    seen: Counter[str] = Counter()
    found = []
    for name in names:
        seen[name] += 1
        plain = name.replace("%", "%25").replace("/", "%2F").replace("#", "%23") or "%"
        again = f"#{seen[name]}" if seen[name] > 1 else ""
        found.append(f"{plain}{again}" if parent is None else f"{parent}/{plain}{again}")
    return tuple(found)
