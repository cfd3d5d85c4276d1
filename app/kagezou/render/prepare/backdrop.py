"""What shows where nothing is drawn."""

from enum import StrEnum

Tone = tuple[float, float, float, float]


class Backdrop(StrEnum):
    """The choices of the viewport; files use TRANSPARENT or BACKGROUND."""

    TRANSPARENT = "transparent"
    CHECKER = "checker"
    GREY = "grey"
    BLACK = "black"
    WHITE = "white"
    BACKGROUND = "background"
    """The document's background picture; transparent where it has none."""

    @property
    def tones(self) -> tuple[Tone, Tone]:
        """The two tones of the squares, sRGB and alpha, 0 to 1."""
        return _TONES[self]


def _grey(level: int) -> Tone:
    return (level / 255, level / 255, level / 255, 1.0)


_CLEAR: Tone = (0.0, 0.0, 0.0, 0.0)
_TONES = {
    Backdrop.TRANSPARENT: (_CLEAR, _CLEAR),
    Backdrop.CHECKER: (_grey(204), _grey(178)),
    # 18 % reflectance: the neutral against which colour is judged.
    Backdrop.GREY: (_grey(118), _grey(118)),
    Backdrop.BLACK: (_grey(0), _grey(0)),
    Backdrop.WHITE: (_grey(255), _grey(255)),
    Backdrop.BACKGROUND: (_CLEAR, _CLEAR),
}
