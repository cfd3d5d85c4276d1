"""What pixels come from: a picture file, or a layer within one. Known to documents, files and drawing alike."""

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path


class Paper(StrEnum):
    """Which white is clear in a picture without alpha."""

    WHITE = "white"
    """All that is pure white."""
    BORDER = "border"
    """Pure white as far as it is connected with the picture's border; white inside an outline stays."""


@dataclass(frozen=True, slots=True)
class PicturePart:
    """A layer, a group or a page within a picture file.

    Parameters
    ----------
    path
        The file.
    address
        What finds it there: in PSD files the names that lead to it, as :func:`kagezou.io.psd.tree.addressed` joins
        them, in OpenEXR files the name of a layer, in others the number of a page from 1.
    paper
        Which white is clear in it where it has no alpha.
    """

    path: Path
    address: str
    paper: Paper = Paper.WHITE


@dataclass(frozen=True, slots=True)
class OutlinedPicture:
    """A picture file in which, where it has no alpha, white is clear by `Paper.BORDER`; in a mere path all of it is."""

    path: Path


PictureSource = Path | PicturePart | OutlinedPicture
"""What pixels come from: a whole file, or a part of one."""


def file_of(source: PictureSource) -> Path:
    """Return the file that a picture comes from."""
    return source if isinstance(source, Path) else source.path
