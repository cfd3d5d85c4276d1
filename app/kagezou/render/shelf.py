"""Textures kept within a budget of memory."""

from collections import OrderedDict
from collections.abc import Callable

from kagezou.render.targets import Texture


class TextureShelf:
    """The textures last used, each made of one object in memory; the least recently used go first."""

    def __init__(self, budget_bytes: int) -> None:
        self._budget = budget_bytes
        self._kept: OrderedDict[int, tuple[object, Texture]] = OrderedDict()

    def texture_of(self, source: object, make: Callable[[], Texture]) -> Texture:
        """Return the texture made of ``source``, which is told by identity; made now if it is not there."""
        key = id(source)
        if key in self._kept:
            self._kept.move_to_end(key)
            return self._kept[key][1]
        texture = make()
        # The source is kept beside its texture, so that its id cannot pass to another object.
        self._kept[key] = (source, texture)
        self._forget_over_budget()
        return texture

    def close(self) -> None:
        """Give the memory back."""
        for _, texture in self._kept.values():
            texture.close()
        self._kept.clear()

    def _forget_over_budget(self) -> None:
        total = sum(texture.nbytes for _, texture in self._kept.values())
        while total > self._budget and len(self._kept) > 1:
            _, (_, oldest) = self._kept.popitem(last=False)
            total -= oldest.nbytes
            oldest.close()
