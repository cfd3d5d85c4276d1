"""What a picture file says about itself before a decoder sees it: name, first bytes, chunk lengths.

Decoders differ in what they notice and some print to the terminal; these checks need no decoder and give one
sentence.
"""

import os
import struct
from pathlib import Path
from typing import BinaryIO, Final

from kagezou.io.files.faults import input_problem
from kagezou.io.pixels.deflating import crc32
from kagezou.message import Message

FORMATS: Final = {
    ".png": "png",
    ".tga": "targa",
    ".tif": "tiff",
    ".tiff": "tiff",
    ".exr": "openexr",
    ".webp": "webp",
    ".jpg": "jpeg",
    ".jpeg": "jpeg",
    ".bmp": "bmp",
    ".gif": "gif",
    ".psd": "psd",
    ".psb": "psd",
}
"""The formats that are read, by lower-case suffix."""

PSD_SUFFIXES: Final = tuple(suffix for suffix, form in FORMATS.items() if form == "psd")

LARGEST_SIDE_PX: Final = 32768
"""The widest and the highest picture that is read."""

_PNG: Final = b"\x89PNG\r\n\x1a\n"
_STARTS: Final = (
    ("png", _PNG),
    ("openexr", b"\x76\x2f\x31\x01"),
    ("jpeg", b"\xff\xd8\xff"),
    ("tiff", b"II*\0"),
    ("tiff", b"MM\0*"),
    ("tiff", b"II+\0"),
    ("tiff", b"MM\0+"),
    ("webp", b"RIFF"),
    ("bmp", b"BM"),
    ("gif", b"GIF8"),
    ("psd", b"8BPS"),
)
_TITLES: Final = {
    "png": "PNG",
    "targa": "TGA",
    "tiff": "TIFF",
    "openexr": "OpenEXR",
    "webp": "WebP",
    "jpeg": "JPEG",
    "bmp": "BMP",
    "gif": "GIF",
    "psd": "PSD",
}
_PNG_HEADER: Final = struct.Struct(">IIBBBBB")
_PNG_DEPTHS: Final = {0: (1, 2, 4, 8, 16), 2: (8, 16), 3: (1, 2, 4, 8), 4: (8, 16), 6: (8, 16)}
_CHUNK_HEAD: Final = 8
_CHUNK_CRC: Final = 4


def is_picture(path: Path) -> bool:
    """Return whether the suffix of ``path``, in any case, is one that is read."""
    return path.suffix.lower() in FORMATS


def is_psd(path: Path) -> bool:
    """Return whether the suffix of ``path``, in any case, is that of a PSD file, which may have many drawings in it."""
    return FORMATS.get(path.suffix.lower()) == "psd"


def checked_format(path: Path, *, whole: bool) -> str:
    """Return the format of the file at ``path``, by its suffix, after looking at its first bytes.

    Parameters
    ----------
    path
        The file.
    whole
        Also walk through the file where its format has lengths and checksums (PNG).

    Raises
    ------
    InputProblem
        An unknown suffix, no such file, not a file, no content, another format inside, or cut short.
    """
    expected = FORMATS.get(path.suffix.lower())
    if expected is None:
        raise input_problem(path, Message("'{suffix}' is not a picture format that can be read", suffix=path.suffix))
    try:
        if path.exists() and not path.is_file():
            raise input_problem(path, Message("it is not a file"))
        with path.open("rb") as stream:
            _check_start(path, stream.read(len(_PNG)), expected)
            if expected == "png":
                _check_png(path, stream, whole=whole)
    except OSError as error:
        raise input_problem(path, error) from error
    except ValueError as error:  # a NUL in the name
        raise input_problem(path, Message("it cannot be a file name")) from error
    return expected


def _check_start(path: Path, start: bytes, expected: str) -> None:
    if not start:
        raise input_problem(path, Message("the file is empty"))
    found = next((name for name, magic in _STARTS if start.startswith(magic)), None)
    if expected == "targa":  # has no mark of its own, and any bytes may open it
        found = found if found in {"png", "openexr", "jpeg"} else "targa"
    if found != expected:
        wanted = _TITLES[expected]
        if found is None:
            raise input_problem(path, Message("it is not {wanted}, whatever its name says", wanted=wanted))
        inside = _TITLES[found]
        raise input_problem(
            path, Message("it is not {wanted} but {inside}, whatever its name says", wanted=wanted, inside=inside)
        )


def _check_png(path: Path, stream: BinaryIO, *, whole: bool) -> None:
    """Check the header, and with ``whole`` the chunks up to IEND; ``stream`` stands after the signature."""
    rest = os.fstat(stream.fileno()).st_size - len(_PNG)
    kind = b""
    while kind != b"IEND":
        head = stream.read(_CHUNK_HEAD)
        length, following = struct.unpack(">I4s", head) if len(head) == _CHUNK_HEAD else (0, b"")
        rest -= _CHUNK_HEAD + length + _CHUNK_CRC
        if rest < 0:
            raise input_problem(path, Message("the file is cut short"))
        body = stream.read(length)
        told = int.from_bytes(stream.read(_CHUNK_CRC))
        needed = following[:1].isupper() or following == b"tRNS"
        if needed and crc32(body, crc32(following)) != told:
            raise input_problem(path, Message("the file is damaged (a checksum is wrong)"))
        if not kind:
            _check_png_header(path, following, body)
            if not whole:
                return
        kind = following


def _check_png_header(path: Path, kind: bytes, body: bytes) -> None:
    if kind != b"IHDR" or len(body) != _PNG_HEADER.size:
        raise input_problem(path, Message("the file is damaged (it has no header)"))
    width, height, bits, colour, packing, filtering, interlace = _PNG_HEADER.unpack(body)
    if bits not in _PNG_DEPTHS.get(colour, ()) or packing or filtering or interlace > 1 or not min(width, height):
        raise input_problem(path, Message("the file is damaged (an impossible header)"))
    if max(width, height) > LARGEST_SIDE_PX:
        raise input_problem(
            path, Message("{width} × {height} px is larger than can be read", width=width, height=height)
        )
