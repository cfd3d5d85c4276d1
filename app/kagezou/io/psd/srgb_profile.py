"""The colour profile of sRGB, for documents that some programs take for linear light without one."""

from functools import cache
from typing import Final

_DATE: Final = slice(24, 36)
_DAY_ONE: Final = bytes((7, 208, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0))
"""2000-01-01, midnight, as six numbers of two bytes."""
_ID: Final = slice(84, 100)


@cache
def srgb_profile() -> bytes:
    """Return an ICC profile of sRGB; always the same bytes, whenever it is made."""
    from PIL import ImageCms

    profile = bytearray(ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes())
    profile[_DATE] = _DAY_ONE
    profile[_ID] = bytes(_ID.stop - _ID.start)
    return bytes(profile)
