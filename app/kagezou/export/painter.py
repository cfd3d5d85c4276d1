"""What contents are drawn with."""

from dataclasses import dataclass

from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Cel, read_cel
from kagezou.picture_source import PictureSource
from kagezou.render.renderer import Renderer


@dataclass(slots=True)
class Painter:
    """Everything that a content needs for being drawn; used on the thread of its renderer.

    Parameters
    ----------
    renderer
        What draws.
    cels
        Where decoded drawings come from.
    depth
        Bits a channel.
    keeps_opacity
        Whether the files hold the opacity of a layer beside its alpha, and all layers merged, as PSD does.
    """

    renderer: Renderer
    cels: CelCache
    depth: int
    keeps_opacity: bool = False
    _background: tuple[PictureSource, Cel] | None = None

    def background(self, source: PictureSource) -> Cel:
        """Return a background, which is read once.

        Raises
        ------
        InputProblem
            It cannot be read.
        """
        if self._background is None or self._background[0] != source:
            self._background = (source, read_cel(source, white_is_clear=False))
        return self._background[1]
