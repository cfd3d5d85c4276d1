"""The one door to OpenImageIO: what it returns is believed only after its error text was asked for.

It is configured once, with limits on what a header may claim. A read counts when an array came back and no error is
pending; a write counts when it was read back equal, because on a full disk it reports success. None of its objects
outlives a call here except inside `DecodedPicture`.
"""

import functools
import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray

from kagezou.errors import DiskFullProblem
from kagezou.io.files.faults import input_problem, output_problem, shown
from kagezou.io.pixels.signatures import LARGEST_SIDE_PX, checked_format
from kagezou.message import Message

LARGEST_PICTURE_MB: Final = 1024
_SETTINGS: Final = {
    "limits:imagesize_MB": LARGEST_PICTURE_MB,
    "limits:resolution": LARGEST_SIDE_PX,
    "limits:channels": 64,
    "try_all_readers": 0,
    "oiio:print_uncaught_errors": 0,
    "imagebuf:print_uncaught_errors": 0,
    "threads": 1,
}
_TYPES: Final = {"uint8": oiio.UINT8, "uint16": oiio.UINT16, "float16": oiio.HALF, "float32": oiio.FLOAT}
_WHOLE: Final = {oiio.UINT8: "uint8", oiio.UINT16: "uint16"}
_FLOATS: Final = frozenset({oiio.HALF, oiio.FLOAT, oiio.DOUBLE})
_STRAIGHT: Final = "oiio:UnassociatedAlpha"
_TGA_PREMULTIPLIED: Final = 4
Pixels = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Header:
    """What a picture's header says.

    Attributes
    ----------
    format
        OpenImageIO's name of the format.
    data, display
        Places of the stored pixels and of the canvas: left, top, width, height in px, y down. They differ only in
        OpenEXR.
    channels
        Names of the stored channels.
    alpha
        Index of the alpha channel, or None.
    alpha_declared
        Whether the file says that its fourth channel is an alpha.
    dtype
        How pixels are delivered: ``uint8``, ``uint16`` or ``float32``.
    bit_depth
        Stored bits per channel.
    straight
        Whether colours are stored without being multiplied by alpha.
    orientation
        Exif number 1..8; 1 is upright.
    """

    format: str
    data: tuple[int, int, int, int]
    display: tuple[int, int, int, int]
    channels: tuple[str, ...]
    alpha: int | None
    alpha_declared: bool
    dtype: str
    bit_depth: int
    straight: bool
    orientation: int


class DecodedPicture:
    """An open picture file, first part only; use it as a context manager in one thread.

    Parameters
    ----------
    path
        The file.
    whole
        Whether its pixels will be wanted, so that its checksums are worth looking at first.

    Raises
    ------
    InputProblem
        Whatever keeps it from being opened, as one sentence.
    """

    def __init__(self, path: Path, *, whole: bool = True) -> None:
        configure()
        checked_format(path, whole=whole)
        self._path = path
        config = oiio.ImageSpec()
        config.attribute(_STRAIGHT, 1)
        oiio.geterror()
        try:
            opened = oiio.ImageInput.open(str(path), config)
        except TypeError as error:  # a name of undecodable bytes does not pass into C++
            raise input_problem(path, Message("its name is not valid text: please rename it")) from error
        except (MemoryError, RuntimeError, ValueError) as error:
            raise input_problem(path, _words_of(str(error))) from error
        if opened is None:
            raise input_problem(path, _words_of(_text_of(oiio.geterror)))
        self._input = opened
        self.header = _header(path, opened)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._input.close()

    def read(self, first: int = 0, end: int | None = None) -> Pixels:
        """Return channels ``first`` to before ``end`` of the stored pixels, (H, W, C) in ``header.dtype``.

        Raises
        ------
        InputProblem
            The data is cut short or damaged, even where the decoder delivered something.
        """
        end = len(self.header.channels) if end is None else end
        wanted = _TYPES[self.header.dtype]
        try:
            pixels = self._input.read_image(0, 0, first, end, wanted)
        except (MemoryError, RuntimeError, ValueError) as error:
            raise input_problem(self._path, _words_of(str(error))) from error
        message = _text_of(self._input.geterror)
        if pixels is None or message:
            raise input_problem(self._path, _words_of(message) if message else Message("its pixels cannot be decoded"))
        return pixels.reshape(self.header.data[3], self.header.data[2], end - first)


def write_verified(temp: Path, pixels: Pixels, settings: Mapping[str, Any], shown_as: Path) -> None:
    """Write ``pixels`` to ``temp`` and read them back.

    Parameters
    ----------
    temp
        Where to write; its suffix chooses the format.
    pixels
        (H, W, 4) RGBA, ``uint8``, ``uint16`` or ``float16``, exactly as the file shall hold them.
    settings
        Attributes of the format, by OpenImageIO's names.
    shown_as
        The file's name in messages.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The writer complains, or what it wrote reads back differently.
    """
    configure()
    cause = _written(temp, pixels, settings) or _differs(temp, pixels)
    if not cause:
        return
    if shutil.disk_usage(temp.parent).free < pixels.nbytes:
        raise disk_full(shown_as)
    raise output_problem(shown_as, Message("cannot be written: {cause}", cause=cause))


def disk_full(shown_as: Path) -> DiskFullProblem:
    """Return the problem of a file for which there is no room."""
    return DiskFullProblem(Message("{path}: cannot be written: no space left on the disk", path=shown(shown_as)))


def _words_of(decoder: str) -> Message:
    """Return what a decoder says, which is in no language of ours."""
    return Message("{words}", words=first_line(decoder))


def _written(temp: Path, pixels: Pixels, settings: Mapping[str, Any]) -> str:
    """Write, and return what went wrong or an empty text."""
    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, _TYPES[pixels.dtype.name])
    for name, value in settings.items():
        spec.attribute(name, value)
    oiio.geterror()
    try:
        out = oiio.ImageOutput.create(str(temp))
        if out is None:
            return _text_of(oiio.geterror)
        done = out.open(str(temp), spec) and out.write_image(pixels)
        done = out.close() and done
    except (TypeError, MemoryError, RuntimeError, ValueError) as error:
        return first_line(str(error))
    message = out.geterror()
    if done and not message:
        return ""
    return first_line(message)


def _differs(temp: Path, pixels: Pixels) -> str:
    """Read back, and return what differs or an empty text."""
    config = oiio.ImageSpec()
    config.attribute(_STRAIGHT, 1)
    source = oiio.ImageInput.open(str(temp), config)
    if source is None:
        return f"it does not read back: {_text_of(oiio.geterror)}"
    back = source.read_image(0, 0, 0, pixels.shape[2], _TYPES[pixels.dtype.name])
    message = _text_of(source.geterror)
    source.close()
    if back is None or message or not np.array_equal(back.view(np.uint8), pixels.view(np.uint8)):
        return "it reads back differently from what was written"
    return ""


@functools.cache
def configure() -> None:
    """Set OpenImageIO up, once."""
    for name, value in _SETTINGS.items():
        oiio.attribute(name, value)


def _header(path: Path, source: oiio.ImageInput) -> Header:
    spec = source.spec()
    if spec.deep or spec.depth > 1:
        raise input_problem(path, Message("deep and volume pictures cannot be read"))
    kind = source.format_name()
    alpha = spec.alpha_channel if 0 <= spec.alpha_channel < spec.nchannels else None
    flagged = bool(spec.get_int_attribute(_STRAIGHT))
    exr = kind == "openexr"
    tga_type = spec.get_int_attribute("targa:alpha_type")
    data = (spec.x, spec.y, spec.width, spec.height) if exr else (0, 0, spec.width, spec.height)
    canvas = (spec.full_x, spec.full_y, spec.full_width, spec.full_height)
    base = spec.format.basetype
    header = Header(
        format=kind,
        data=data,
        display=canvas if exr else data,
        channels=tuple(spec.channelnames),
        alpha=alpha,
        alpha_declared=alpha is not None and (flagged or kind not in {"targa", "bmp"} or tga_type >= 3),
        dtype=_WHOLE.get(base, "float32" if base in _FLOATS else "uint16"),
        bit_depth=spec.get_int_attribute("oiio:BitsPerSample", spec.format.size() * 8),
        straight=flagged or not (exr or kind == "tiff" or tga_type == _TGA_PREMULTIPLIED),
        orientation=spec.get_int_attribute("Orientation", 1),
    )
    _check_size(path, header)
    return header


def _check_size(path: Path, header: Header) -> None:
    """Refuse a canvas that would not be allocated; the stored pixels were limited when opening."""
    width, height = header.display[2:]
    pixel_bytes = 4 if header.dtype == "uint8" else 8
    if width < 1 or height < 1:
        raise input_problem(path, Message("it has no pixels"))
    if max(width, height) > LARGEST_SIDE_PX or width * height * pixel_bytes > LARGEST_PICTURE_MB << 20:
        raise input_problem(
            path, Message("{width} × {height} px is larger than can be read", width=width, height=height)
        )


def _text_of(ask: Any) -> str:
    """Return the pending error as one line; damaged files may put bytes into it that are no text."""
    try:
        return first_line(ask())
    except UnicodeDecodeError:
        return "it cannot be decoded"


def first_line(text: str) -> str:
    """Return the first line of an error, which is the one that a person can use."""
    return text.strip().partition("\n")[0].strip() or ""
