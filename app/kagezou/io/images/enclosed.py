"""How much of the figure of a picture without alpha is white."""

from typing import Final

import numpy as np

from kagezou.io.images.reading import has_alpha, read_cel
from kagezou.io.images.white_paper import white_of
from kagezou.io.pixels.paper import reaching_border
from kagezou.picture_source import PictureSource

_FILLED: Final = 0.9
"""What takes more of a picture than this is not its figure."""


def enclosed_part(source: PictureSource) -> float:
    """Return how much of the figure of a picture without alpha is white inside an outline, 0 to 1; 0 with alpha.

    The figure is all that is not white or does not reach the border; one that fills the picture is a frame drawn around
    it, or no figure on paper at all, and nothing is inside of it.

    Raises
    ------
    InputProblem
        As for `read_cel`.
    """
    if has_alpha(source):
        return 0.0
    rgba = read_cel(source, white_is_clear=False).rgba
    white = white_of(rgba)
    figure = white.size - int(np.count_nonzero(reaching_border(white)))
    colored = white.size - int(np.count_nonzero(white))
    return (figure - colored) / figure if 0 < figure < _FILLED * white.size else 0.0
