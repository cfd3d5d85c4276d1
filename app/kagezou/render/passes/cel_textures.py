"""Cels on the graphics card, in colour."""

from kagezou.io.images.reading import Cel
from kagezou.render.gpu.made_of_cache import MadeOfCache
from kagezou.render.gpu.targets import Format, Texture


class CelTextures:
    """The figures of the cels last used: only those parts of the drawings travel to the graphics card."""

    def __init__(self, budget_bytes: int) -> None:
        self._kept: MadeOfCache[Texture] = MadeOfCache(budget_bytes)

    def texture(self, cel: Cel) -> Texture:
        """Return the part of a cel in the box of its matte, which must not be empty: straight colour and alpha."""
        return self._kept.made_of(cel, lambda: _uploaded(cel))

    def close(self) -> None:
        """Give the memory back."""
        self._kept.close()


def _uploaded(cel: Cel) -> Texture:
    box = cel.matte.box
    assert box is not None
    form = Format.RGBA8 if cel.rgba.dtype.itemsize == 1 else Format.RGBA16
    texture = Texture(box.width, box.height, form)
    texture.upload_part(cel.rgba, box)
    return texture
