"""The one door to Pillow: films and other files that OpenImageIO does not give whole, at 8 bit.

Whatever it raises is one sentence. Its pictures are opened without their pixels and decoded one at a time.
"""

import functools
import io
import threading
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.images.header import Header
from kagezou.io.images.oiio_header import no_such_part
from kagezou.io.images.picture_size import check_size
from kagezou.io.pixels import riff
from kagezou.io.pixels.icc import change_by_profile
from kagezou.message import Message

Pixels = NDArray[Any]
_MODES: Final = {"L": 1, "LA": 2, "RGB": 3, "RGBA": 4}
_ROWS: Final = 256
_FORMATS: Final = ("PNG", "WEBP", "GIF", "TIFF", "JPEG", "TGA")
_INKS_WITHOUT_PROFILE: Final = Message("its inks (CMYK) have no colour profile: its colours are an approximation")
_INKS: Final = Message("its inks (CMYK) were turned into sRGB by its colour profile")


@functools.cache
def _pillow() -> Any:
    """Return Pillow's module of pictures, set up once; it is imported with the first file that needs it."""
    from PIL import Image, ImageFile

    Image.MAX_IMAGE_PIXELS = None  # the sides and the memory are looked at by `check_size`
    ImageFile.LOAD_TRUNCATED_IMAGES = False
    return Image


def encode_jpeg(rgb: Pixels, quality: int) -> bytes:
    """Return the JPEG of a picture, (H, W, 3) ``uint8`` sRGB; ``quality`` is 1 to 95."""
    stream = io.BytesIO()
    _pillow().fromarray(np.ascontiguousarray(rgb)).save(stream, "JPEG", quality=quality, optimize=True)
    return stream.getvalue()


@contextmanager
def pillow_problems(path: Path) -> Iterator[None]:
    """Turn whatever Pillow raises into one sentence about ``path``."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            yield
        except InputProblem:
            raise
        except OSError as error:
            if error.errno is not None:
                raise input_problem(path, error) from error
            raise _undecodable(path, error) from error
        except Exception as error:  # a stranger's file may trip it in any way
            raise _undecodable(path, error) from error


def _undecodable(path: Path, error: Exception) -> InputProblem:
    if isinstance(error, EOFError) or "truncated" in str(error):
        return input_problem(path, Message("the file is cut short"))
    return input_problem(path, Message("the file is damaged or of an unknown kind ({cause})", cause=_cause(error)))


def _cause(error: Exception) -> str:
    """Return the first line of an error without the names of files in memory."""
    text = str(error).strip().partition("\n")[0].partition("<_io")[0].strip()
    return text[:120] or type(error).__name__


class PillowFile:
    """A picture file in memory, decoded by Pillow; used by one thread at a time.

    Parameters
    ----------
    path
        The file, to be named in a problem.
    data
        Its bytes.

    Raises
    ------
    InputProblem
        Whatever keeps it from being opened, as one sentence.
    """

    def __init__(self, path: Path, data: bytes) -> None:
        self._path = path
        self._lock = threading.Lock()
        self._data = data
        self._shown = riff.with_open_alpha(data) if data[8:12] == b"WEBP" else data
        with pillow_problems(path):
            self._image = self._opened()
            count = int(getattr(self._image, "n_frames", 1))
            # A PNG film may have a picture before it for programs that show no films.
            self._first = 1 if self._image.info.get("default_image") and count > 1 else 0
            self.pictures = count - self._first
            self.header = self._header()
            self.nbytes = len(self._shown) + 2 * 4 * self._image.size[0] * self._image.size[1]
        check_size(path, self.header)

    def durations_ms(self) -> tuple[float, ...]:
        """Return how long each picture is seen, 0 where the file does not say; raises InputProblem."""
        if self._image.format == "WEBP":  # which says so of a picture only when it is decoded
            said = riff.durations_ms(io.BytesIO(self._data))
            return (*said, *[0.0] * self.pictures)[: self.pictures]
        found = []
        with self._lock, pillow_problems(self._path):
            for index in range(self.pictures):
                self._seek(index)
                found.append(float(self._image.info.get("duration", 0)))
        return tuple(found)

    def check(self, index: int) -> None:
        """Raise InputProblem where there is no picture of that place."""
        if index >= self.pictures:
            raise no_such_part(self._path, str(index + 1))

    def read(self, index: int) -> Pixels:
        """Return a picture by its place from 0, (H, W, C) ``uint8``, with the channels that the header says.

        Raises
        ------
        InputProblem
            There is no such picture, or its data is cut short or damaged.
        """
        self.check(index)
        with self._lock, pillow_problems(self._path):
            self._seek(index)
            self._image.load()
            if self._image.mode == "CMYK":
                return np.asarray(self._in_rgb())
            mode = next(name for name, count in _MODES.items() if count == self.header.channels)
            return self._pixels(mode)

    def _opened(self) -> Any:
        return _pillow().open(io.BytesIO(self._shown), formats=_FORMATS)

    def _seek(self, index: int) -> None:
        """Go to a picture; for an earlier one the file is opened anew, as Pillow loses its way in a PNG going back."""
        if self._first + index < self._image.tell():
            self._image = self._opened()
        self._image.seek(self._first + index)

    def _pixels(self, mode: str) -> Pixels:
        """Return the loaded picture in a mode; some rows at a time, as a large one takes enough memory by itself."""
        width, height = self._image.size
        pixels = np.empty((height, width, _MODES[mode]), np.uint8)
        for top in range(0, height, _ROWS):
            rows = self._image.crop((0, top, width, min(top + _ROWS, height)))
            part = np.asarray(rows if rows.mode == mode else rows.convert(mode))
            pixels[top : top + _ROWS] = part if part.ndim == 3 else part[..., None]
        return pixels

    def _header(self) -> Header:
        image = self._image
        has_alpha = bool(image.has_transparency_data or "A" in image.mode)
        is_gray = image.mode in {"1", "L", "LA", "I;16", "I"}
        colours = 1 if is_gray else 3
        place = (0, 0, *image.size)
        profile = image.info.get("icc_profile") or b""
        found = change_by_profile(profile, is_gray=is_gray) if profile and image.mode != "CMYK" else None
        notes = (found,) if isinstance(found, Message) else ()
        if image.mode == "CMYK":
            notes = (_INKS if profile else _INKS_WITHOUT_PROFILE,)
        return Header(
            format=str(image.format).lower(),
            data=place,
            display=place,
            channels=colours + has_alpha,
            colour=tuple(range(colours)),
            alpha=colours if has_alpha else None,
            dtype="uint8",
            bit_depth=8,
            orientation=int(image.getexif().get(274, 1)),
            change=None if isinstance(found, Message) else found,
            notes=notes,
        )

    def _in_rgb(self) -> Any:
        """Return a picture of inks in RGB, by its profile where it has one."""
        profile = self._image.info.get("icc_profile")
        if not profile:
            return self._image.convert("RGB")
        from PIL import ImageCms

        screen = ImageCms.createProfile("sRGB")
        inks = ImageCms.ImageCmsProfile(io.BytesIO(profile))
        return ImageCms.profileToProfile(self._image, inks, screen, outputMode="RGB")
