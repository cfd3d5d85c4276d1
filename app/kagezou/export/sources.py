"""What pictures of an export are made of."""

from dataclasses import dataclass
from pathlib import Path

from kagezou.picture_source import PictureSource, file_of


@dataclass(frozen=True, slots=True)
class Sources:
    """What a picture is made of.

    Parameters
    ----------
    mattes
        Drawings of which it needs the alpha.
    cels
        Drawings that it needs in colour.
    background
        A background, whole.
    sets
        Files of imported sets.
    """

    mattes: tuple[PictureSource, ...] = ()
    cels: tuple[PictureSource, ...] = ()
    background: PictureSource | None = None
    sets: tuple[Path, ...] = ()

    @property
    def pictures(self) -> tuple[PictureSource, ...]:
        """All but the sets."""
        return (*self.mattes, *self.cels, *([] if self.background is None else [self.background]))

    @property
    def files(self) -> tuple[Path, ...]:
        """Every file that must be there."""
        return (*map(file_of, self.pictures), *self.sets)
