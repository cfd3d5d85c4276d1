"""The one door to OpenImageIO: what it returns is believed only after its error text was asked for.

It is configured once, with limits on what a header may claim. A read counts when an array came back and no error is
pending; a write counts when it was read back equal, because on a full disk it reports success. None of its objects
outlives a call here except inside `DecodedPicture`.
"""

import functools
import shutil
from collections.abc import Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, Final, Self

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray

from kagezou.errors import DiskFullProblem
from kagezou.io.files.faults import input_problem, output_problem, shown
from kagezou.io.images.exr_layers import chosen_layer
from kagezou.io.images.fast_png import fast_pixels
from kagezou.io.images.oiio_errors import first_line, text_of
from kagezou.io.images.oiio_header import STRAIGHT, exr_layers, full_pages, header_of
from kagezou.io.images.picture_size import LARGEST_PICTURE_MB, check_size
from kagezou.io.pixels import riff
from kagezou.io.pixels.completeness import is_written_whole
from kagezou.io.pixels.png_chunks import png_chunks
from kagezou.io.pixels.signatures import LARGEST_SIDE_PX, checked_format
from kagezou.message import Message

_SETTINGS: Final = {
    # Of all channels together, of which a few are read; what these take is looked at by `check_size`.
    "limits:imagesize_MB": 32 * LARGEST_PICTURE_MB,
    "limits:resolution": LARGEST_SIDE_PX,
    "limits:channels": 1024,
    "try_all_readers": 0,
    "oiio:print_uncaught_errors": 0,
    "imagebuf:print_uncaught_errors": 0,
    "threads": 1,
}
_TYPES: Final = {"uint8": oiio.UINT8, "uint16": oiio.UINT16, "float16": oiio.HALF, "float32": oiio.FLOAT}
Pixels = NDArray[Any]


class DecodedPicture:
    """An open picture file, one picture of it; use it as a context manager in one thread.

    Parameters
    ----------
    path
        The file.
    whole
        Whether its pixels will be wanted, so that its checksums are worth looking at first.
    address
        The layer or the page that is meant, as `header_of` takes it.

    Raises
    ------
    InputProblem
        Whatever keeps it from being opened, as one sentence.
    """

    def __init__(self, path: Path, *, whole: bool = True, address: str | None = None) -> None:
        configure()
        checked_format(path, whole=whole)
        self._path = path
        config = oiio.ImageSpec()
        config.attribute(STRAIGHT, 1)
        oiio.geterror()
        try:
            opened = oiio.ImageInput.open(str(path), config)
        except TypeError as error:  # a name of undecodable bytes does not pass into C++
            raise input_problem(path, Message("its name is not valid text: please rename it")) from error
        except (MemoryError, RuntimeError, ValueError) as error:
            raise input_problem(path, _words_of(str(error))) from error
        if opened is None:
            raise input_problem(path, _words_of(text_of(oiio.geterror)))
        self._input = opened
        self.header = header_of(path, opened, address)
        check_size(path, self.header)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._input.close()

    def read(self, first: int = 0, end: int | None = None) -> Pixels:
        """Return channels ``first`` to before ``end`` of the stored pixels, (H, W, C) in ``header.dtype``.

        What a faster decoder reads as well comes from there.

        Raises
        ------
        InputProblem
            The data is cut short or damaged, even where the decoder delivered something.
        """
        end = self.header.channels if end is None else end
        fast = fast_pixels(self._path, self.header) if end - first == self.header.channels else None
        return self._own_pixels(first, end) if fast is None else fast

    def _own_pixels(self, first: int, end: int) -> Pixels:
        wanted = _TYPES[self.header.dtype]
        try:
            pixels = self._input.read_image(self.header.subimage, 0, first, end, wanted)
        except (MemoryError, RuntimeError, ValueError) as error:
            raise input_problem(self._path, _words_of(str(error))) from error
        message = text_of(self._input.geterror)
        if pixels is None or message:
            raise input_problem(self._path, _words_of(message) if message else Message("its pixels cannot be decoded"))
        return pixels.reshape(self.header.data[3], self.header.data[2], end - first)

    def used(self) -> Pixels:
        """Return the channels that are used, (H, W, C) in the order of ``header.used``; raises InputProblem."""
        used = self.header.used
        if not self.header.is_floating:
            stored = self.read()
            return stored if used == tuple(range(self.header.channels)) else stored[..., list(used)]
        first, end = min(used), max(used) + 1
        if end - first <= len(used) + 1:
            stored = self.read(first, end)
            places = [each - first for each in used]
            return stored if places == list(range(end - first)) else stored[..., places]
        # Between them lie channels of other layers, which may be many.
        found = np.empty((self.header.data[3], self.header.data[2], len(used)), self.header.dtype)
        for place, each in enumerate(used):
            found[..., place] = self.read(each, each + 1)[..., 0]
        return found

    def alpha(self) -> Pixels:
        """Return the alpha alone, (H, W), where there is one; raises InputProblem.

        Of integer files all channels are read: to pick one while decoding takes half as long again as to pick it out of
        the pixels.
        """
        index = self.header.alpha
        assert index is not None
        if self.header.is_floating:
            return self.read(index, index + 1)[..., 0]
        return self.read()[..., index]

    def layer_names(self) -> tuple[str, ...]:
        """Return the names of the layers of an OpenEXR file that can be a picture, the one used by itself first."""
        layers = [each for each in exr_layers(self._input)[0] if each.is_picture]
        usual = chosen_layer(layers)
        return tuple(each.name for each in sorted(layers, key=lambda each: each is not usual))

    def pictures(self) -> int:
        """Return how many pictures the file has beside smaller copies of them."""
        kind = self.header.format
        if kind == "png":
            return png_chunks(self._path).pictures
        if kind == "webp":
            with self._path.open("rb") as stream:
                return max(len(riff.durations_ms(stream)), 1)
        return len(full_pages(self._input)) if kind == "tiff" else 1


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
    cause = _written(temp, pixels, settings) or _differs(temp, pixels) or lacks_end(temp)
    if not cause:
        return
    if shutil.disk_usage(temp.parent).free < pixels.nbytes:
        raise disk_full(shown_as)
    raise output_problem(shown_as, Message("cannot be written: {cause}", cause=cause))


def lacks_end(temp: Path) -> str:
    """Return that a file ends too early, or an empty text; a reader may not need what is missing."""
    return "" if is_written_whole(temp) else "its end never reached the disk"


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
            return text_of(oiio.geterror)
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
    config.attribute(STRAIGHT, 1)
    source = oiio.ImageInput.open(str(temp), config)
    if source is None:
        return f"it does not read back: {text_of(oiio.geterror)}"
    back = source.read_image(0, 0, 0, pixels.shape[2], _TYPES[pixels.dtype.name])
    message = text_of(source.geterror)
    source.close()
    if back is None or message or not np.array_equal(back.view(np.uint8), pixels.view(np.uint8)):
        return "it reads back differently from what was written"
    return ""


@functools.cache
def configure() -> None:
    """Set OpenImageIO up, once."""
    for name, value in _SETTINGS.items():
        oiio.attribute(name, value)
