"""What the header of a picture file says, with the layer of it that is meant, and what of the file is left out."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from kagezou.io.pixels.colour_change import ColourChange
from kagezou.message import Message

_NAMED: Final = 5
"""So many parts of a file that are not used are named."""


@dataclass(frozen=True, slots=True, eq=False)
class Header:
    """What a picture's header says.

    Attributes
    ----------
    format
        OpenImageIO's name of the format.
    data, display
        Places of the stored pixels and of the canvas: left, top, width, height in px, y down. They differ only in
        OpenEXR.
    subimage
        Which picture of the file it is, from 0.
    channels
        How many channels are stored.
    colour
        Indices of the stored channels that are red, green and blue; one of gray, or none.
    alpha
        Index of the alpha channel, or None.
    alpha_declared
        Whether the file says that this channel is an alpha.
    dtype
        How pixels are delivered: ``uint8``, ``uint16``, ``float16`` or ``float32``.
    bit_depth
        Stored bits per channel.
    straight
        Whether colours are stored without being multiplied by alpha.
    orientation
        Exif number 1..8; 1 is upright.
    white_is_zero
        Whether the numbers of gray go from white to black.
    change
        From the colours of the file to sRGB, None where they are that.
    is_for_pillow
        Whether the other decoder gives more of it.
    notes
        What of the file is not used, and what had to be assumed.
    """

    format: str
    data: tuple[int, int, int, int]
    display: tuple[int, int, int, int]
    channels: int
    colour: tuple[int, ...]
    alpha: int | None
    dtype: str
    bit_depth: int
    alpha_declared: bool = True
    straight: bool = True
    orientation: int = 1
    subimage: int = 0
    white_is_zero: bool = False
    change: ColourChange | None = None
    is_for_pillow: bool = False
    notes: tuple[Message, ...] = ()

    @property
    def is_floating(self) -> bool:
        """Whether pixels are delivered as floating point numbers, which are linear light."""
        return self.dtype.startswith("float")

    @property
    def used(self) -> tuple[int, ...]:
        """The indices of the channels that are used: the colours, then the alpha."""
        return self.colour if self.alpha is None else (*self.colour, self.alpha)


def not_used(names: Sequence[str]) -> tuple[Message, ...]:
    """Return the note on layers, channels and other parts of a file that are not used; none for no names."""
    if not names:
        return ()
    listed = ", ".join(names[:_NAMED])
    if len(names) > _NAMED:
        return (Message("not used of it: {names} and {count} more", names=listed, count=len(names) - _NAMED),)
    return (Message("not used of it: {names}", names=listed),)
