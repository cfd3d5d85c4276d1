"""Packing by deflate: the same bytes for the same content, whatever else goes on.

Which level of which library is not a matter of speed alone. From level 1 on, isal chooses now and then otherwise
between two matches that are as long, once several threads pack: of ten thousand equal pictures some twenty differed in
two bytes. It does so by a table in memory that it asks for each time; level 0 has none, and with it and with zlib-ng
none differed.
"""

from typing import Any, Final, TypeAlias

from isal import isal_zlib
from numpy.typing import NDArray
from zlib_ng import zlib_ng

Packable: TypeAlias = bytes | NDArray[Any]
"""Bytes, or an array that lies in one piece."""

_SMALL_LEVEL: Final = 2
_FAST_LEVEL: Final = 0


def packed_small(data: Packable) -> bytes:
    """Return ``data`` as a zlib stream, never much larger than itself; zeros are packed as fast as by `packed_fast`."""
    return zlib_ng.compress(data, _SMALL_LEVEL)


def packed_fast(data: Packable) -> bytes:
    """Return ``data``, a painted picture, as a zlib stream in a quarter of the time that `packed_small` takes.

    Noise becomes larger by a third, which some readers of TIFF do not expect.
    """
    return isal_zlib.compress(data, _FAST_LEVEL)


def crc32(data: Packable, start: int = 0) -> int:
    """Return the checksum of PNG and zip; ``start`` is that of what came before."""
    return isal_zlib.crc32(data, start)
