"""What pixels come from: a picture file, or a layer within one. Known to documents, files and drawing alike."""

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class PicturePart:
    """A layer or a group within a picture file.

    Parameters
    ----------
    path
        The file.
    address
        The names that lead to it, as :func:`kagezou.io.psd.tree.addressed` joins them.
    """

    path: Path
    address: str


PictureSource = Path | PicturePart
"""What pixels come from: a whole file, or a part of one."""


def file_of(source: PictureSource) -> Path:
    """Return the file that a picture comes from."""
    return source.path if isinstance(source, PicturePart) else source
