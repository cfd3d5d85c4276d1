"""What the chunks before the pixels of a PNG file say: its colours, and whether it is a film."""

import functools
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.io.pixels.colour_change import (
    REC709,
    Chromaticities,
    ColourChange,
    light_change,
    power_curves,
    srgb_curves,
)
from kagezou.message import Message

_SIGNATURE_BYTES: Final = 8
_LONGEST: Final = 1 << 16
_MOST_CHUNKS: Final = 1000
_ASKED: Final = frozenset({b"IHDR", b"cICP", b"iCCP", b"sRGB", b"gAMA", b"cHRM", b"acTL"})
_REC2020: Final = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
_DISPLAY_P3: Final = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)
_PRIMARIES: Final[dict[int, Chromaticities]] = {1: REC709, 9: _REC2020, 12: _DISPLAY_P3}
"""By their numbers in ITU-T H.273."""

_AS_ON_SCREENS: Final = frozenset({1, 6, 13, 14, 15})
"""Transfer functions of H.273 that screens show as sRGB."""

_LINEAR: Final = 8
_USUAL_GAMMA: Final = 45455
_NEARLY: Final = 500


@dataclass(frozen=True, slots=True)
class PngChunks:
    """What stands before the pixels.

    Attributes
    ----------
    bodies
        By the names of the chunks, of those asked for.
    """

    bodies: dict[bytes, bytes]

    @property
    def pictures(self) -> int:
        """How many pictures the file says that it plays; 1 for no film."""
        body = self.bodies.get(b"acTL", b"")
        return max(struct.unpack(">II", body)[0], 1) if len(body) == 8 else 1

    @property
    def has_profile(self) -> bool:
        """Whether a colour profile is what counts; a more exact chunk goes before it."""
        return b"iCCP" in self.bodies and b"cICP" not in self.bodies

    def colour_change(self) -> ColourChange | Message | None:
        """Return the change of its colours to sRGB as its chunks but a profile say, or a note that they are not used.

        By the standard cICP counts before a profile, that before sRGB, and that before gAMA and cHRM.
        """
        cicp = self.bodies.get(b"cICP", b"")
        if len(cicp) == 4:
            return _by_numbers(*cicp)
        if b"iCCP" in self.bodies or b"sRGB" in self.bodies:
            return None
        return _by_gamma(self.bodies.get(b"gAMA", b""), self.bodies.get(b"cHRM", b""))


def png_chunks(path: Path) -> PngChunks:
    """Return what stands before the pixels of the PNG file at ``path``; raises OSError where it cannot be read."""
    bodies: dict[bytes, bytes] = {}
    with path.open("rb") as stream:
        stream.seek(_SIGNATURE_BYTES)
        for _ in range(_MOST_CHUNKS):
            head = stream.read(8)
            if len(head) < 8:
                break
            length, name = struct.unpack(">I4s", head)
            if name in {b"IDAT", b"IEND"}:
                break
            if name in _ASKED:
                bodies[name] = stream.read(min(length, _LONGEST))
                stream.seek(max(length - _LONGEST, 0) + 4, 1)
            else:
                stream.seek(length + 4, 1)
    return PngChunks(bodies)


@functools.lru_cache(maxsize=16)
def _by_numbers(primaries: int, transfer: int, _matrix: int, _range: int) -> ColourChange | Message | None:
    known = _PRIMARIES.get(primaries)
    if known is None or transfer not in _AS_ON_SCREENS | {_LINEAR}:
        return Message(
            "its colours are taken as sRGB, though it calls them {primaries}/{transfer}",
            primaries=primaries,
            transfer=transfer,
        )
    return light_change(known, power_curves(1.0) if transfer == _LINEAR else srgb_curves())


@functools.lru_cache(maxsize=16)
def _by_gamma(gamma: bytes, primaries: bytes) -> ColourChange | None:
    number = int.from_bytes(gamma) if len(gamma) == 4 else 0
    source = REC709
    if len(primaries) == 32:
        wx, wy, rx, ry, gx, gy, bx, by = (each / 100000 for each in struct.unpack(">8I", primaries))
        source = (rx, ry, gx, gy, bx, by, wx, wy)
    elif not number:
        return None
    if not number or abs(number - _USUAL_GAMMA) <= _NEARLY:
        return light_change(source, srgb_curves())
    exponent = 100000 / number
    return light_change(source, power_curves(exponent)) if 0.1 <= exponent <= 10 else None
