"""What layers were on a frame, kept while nothing changes that they are made of."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kagezou.document.model import Document, Layer
from kagezou.scene.scene import LayerScene


@dataclass(frozen=True, slots=True)
class _Known:
    frame: int
    made_of: tuple[object, ...]
    scene: LayerScene

    def holds(self, frame: int, made_of: tuple[object, ...]) -> bool:
        return (
            self.frame == frame
            and len(self.made_of) == len(made_of)
            and all(before is now for before, now in zip(self.made_of, made_of, strict=True))
        )


class KnownLayers:
    """The scenes of the layers of one document on one frame, for whoever evaluates it again after each small edit.

    An edit keeps what it does not change: the very same records tell that a layer is the same.
    """

    def __init__(self) -> None:
        self._known: dict[str, _Known] = {}
        self.times_made = 0

    def scenes(
        self, document: Document, frame: int, layers: Sequence[Layer], make: Callable[[Layer], LayerScene]
    ) -> tuple[LayerScene, ...]:
        """Return the scenes of some of a document's layers, made only where they may be others than last time.

        Parameters
        ----------
        make
            Makes the scene of a layer on the frame, of nothing but canvas, properties of the scene and layers of its
            figure.
        """
        figures: dict[str, list[Layer]] = {}
        for layer in document.layers:
            figures.setdefault(layer.joins or layer.id, []).append(layer)
        found: dict[str, _Known] = {}
        for layer in layers:
            made_of = (document.canvas, document.tracks, layer, *figures[layer.joins or layer.id])
            known = self._known.get(layer.id)
            if known is None or not known.holds(frame, made_of):
                known = _Known(frame, made_of, make(layer))
                self.times_made += 1
            found[layer.id] = known
        self._known = found
        return tuple(each.scene for each in found.values())
