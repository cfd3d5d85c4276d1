"""What is drawn of a content, and how it becomes a file."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem
from kagezou.io.images.writing import ShadowImage, encode_png, encode_rgba_png, write_rgba, write_shadow

if TYPE_CHECKING:  # what layers are written with is loaded with the first of them
    from kagezou.io.pixels.layers import LayeredImage

Pixels = NDArray[Any]


class Picture(ABC):
    """A drawn picture."""

    @abstractmethod
    def write(self, path: Path) -> bytes:
        """Write it in the format of the suffix; return the bytes of the file.

        Raises
        ------
        UsageProblem
            The suffix is of no format that holds such a picture.
        DiskFullProblem, OutputProblem
            It cannot be written; what was at ``path`` is still there.
        """

    @abstractmethod
    def rgba(self) -> Pixels:
        """Return it flat: straight sRGB, (H, W, 4) ``uint8`` or ``uint16``.

        Raises
        ------
        ValueError
            It was drawn as layers alone.
        """


@dataclass(frozen=True, slots=True, eq=False)
class ShadowPicture(Picture):
    """A shadow, clear outside a box."""

    image: ShadowImage

    def write(self, path: Path) -> bytes:
        """Write it."""
        if path.suffix == ".png":
            return _written(path, encode_png(self.image))
        return _written_by(lambda: write_shadow(path, self.image), path)

    def rgba(self) -> Pixels:
        """Return the whole canvas."""
        return self.image.rgba()


@dataclass(frozen=True, slots=True, eq=False)
class FlatPicture(Picture):
    """A whole canvas of straight sRGB, (H, W, 4) ``uint8`` or ``uint16``."""

    pixels: Pixels

    def write(self, path: Path) -> bytes:
        """Write it."""
        if path.suffix == ".png":
            return _written(path, encode_rgba_png(self.pixels))
        return _written_by(lambda: write_rgba(path, self.pixels), path)

    def rgba(self) -> Pixels:
        """Return its pixels."""
        return self.pixels


@dataclass(frozen=True, slots=True, eq=False)
class LayeredPicture(Picture):
    """A canvas of layers."""

    image: "LayeredImage"

    def write(self, path: Path) -> bytes:
        """Write it."""
        from kagezou.io.images.layered import write_layered

        return _written_by(lambda: write_layered(path, self.image), path)

    def rgba(self) -> Pixels:
        """Return the layers merged, where they were drawn so too."""
        if self.image.merged is None:
            raise ValueError("the layers of this picture were not merged")
        return self.image.merged


def _written(path: Path, data: bytes) -> bytes:
    write_bytes(path, data)
    return data


def _written_by(write: Callable[[], None], path: Path) -> bytes:
    """Let a writer of files write one and return what it wrote."""
    write()
    try:
        return path.read_bytes()
    except OSError as error:
        raise output_problem(path, error) from error
