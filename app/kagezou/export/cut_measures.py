"""What an artist looks at in a shadow over a whole cut, as numbers."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import atan2, degrees, hypot, sqrt
from typing import Final

import numpy as np
from numpy.typing import NDArray

from kagezou.document.model import Document
from kagezou.geometry.camera import project
from kagezou.io.pixels.connected import part_areas
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.companions import without_companions
from kagezou.scene.evaluate import contact_of, evaluate
from kagezou.scene.scene import LayerScene, Scene

Mask = NDArray[np.bool_]

_HALF: Final = 32768
_HALF_OPAQUE: Final = 128

_UNDER: Final = 0.4
"""Nearer than this part of its width and height together a shadow lies under its figure."""


@dataclass(frozen=True, slots=True)
class ShadowSeen:
    """A figure's shadow on one frame.

    Parameters
    ----------
    area_px2
        Of all that is at least half covered, canvas px².
    part_areas_px2
        Of its islands, the largest first.
    hole_areas_px2
        Of its holes, the largest first.
    hidden
        Which part of it lies under the figure, 0 to 1.
    direction_deg
        Where its middle lies, seen from where the figure stands: 0 to the right, 90 down.
    away_px
        How far from there.
    outline_px
        How far its outline moved since the frame before, on average; None on the first frame and without a shadow.
    drawing_px
        The same of the figure's own outline.
    """

    area_px2: float
    part_areas_px2: tuple[float, ...]
    hole_areas_px2: tuple[float, ...]
    hidden: float
    direction_deg: float
    away_px: float
    outline_px: float | None
    drawing_px: float | None

    @property
    def is_under_figure(self) -> bool:
        """Whether its middle is so near to where the figure stands that it has no direction."""
        return self.away_px < _UNDER * sqrt(self.area_px2)

    @property
    def main_share(self) -> float:
        """Which part of the shadow its largest island is."""
        return self.part_areas_px2[0] / self.area_px2 if self.part_areas_px2 else 1.0


def shadow_over_cut(
    document: Document, figure_id: str, frames: Sequence[int], renderer: Renderer
) -> tuple[ShadowSeen, ...]:
    """Return what is seen of a figure's shadow on frames that follow one another; frames without one are left out.

    Parameters
    ----------
    document, figure_id
        The cut, and the layer of the figure.
    frames
        Upward.
    renderer
        What draws, with the context that is current.
    """
    return tuple(_seen(document, figure_id, frames, renderer))


def _seen(document: Document, figure_id: str, frames: Sequence[int], renderer: Renderer) -> Iterator[ShadowSeen]:
    before: tuple[Mask, Mask] | None = None
    for frame in frames:
        scene = evaluate(document, frame)
        layer = next((each for each in scene.layers if each.id == figure_id), None)
        if layer is None or layer.cast is None:
            before = None
            continue
        shadow = renderer.coverage(scene, layer) >= _HALF
        figure = _figure(scene, figure_id, renderer)
        if shadow.any():
            yield _measured(scene, layer, shadow, figure, before)
        before = (shadow, figure) if shadow.any() else None


def _measured(
    scene: Scene, layer: LayerScene, shadow: Mask, figure: Mask, before: tuple[Mask, Mask] | None
) -> ShadowSeen:
    rows, columns = np.nonzero(shadow)
    stands = project(scene.camera.canvas_from_world(), (*contact_of(layer.card, scene.ground), 1.0))
    away = (float(columns.mean()) + 0.5 - stands[0], float(rows.mean()) + 0.5 - stands[1])
    area = float(len(rows))
    return ShadowSeen(
        area,
        tuple(part_areas(shadow, diagonal=True).tolist()),
        # What is around the shadow is the largest part of what is not in it.
        tuple(part_areas(~np.pad(shadow, 1), diagonal=False)[1:].tolist()),
        float(np.count_nonzero(shadow & figure)) / area,
        degrees(atan2(away[1], away[0])),
        hypot(*away),
        None if before is None else _moved(before[0], shadow),
        None if before is None else _moved(before[1], figure),
    )


def _moved(before: Mask, after: Mask) -> float:
    """Return how far an outline went from one mask to another: the area it passed over, by its length."""
    passed = float(np.count_nonzero(before != after))
    return 2 * passed / max(_length(before) + _length(after), 1.0)


def _length(mask: Mask) -> float:
    """Return the length of the outline of a mask: half the crossings of rows and columns are those of a circle."""
    crossings = np.count_nonzero(mask[1:] != mask[:-1]) + np.count_nonzero(mask[:, 1:] != mask[:, :-1])
    return float(crossings) * np.pi / 4


def _figure(scene: Scene, figure_id: str, renderer: Renderer) -> Mask:
    """Return where the drawings of a figure are at least half opaque."""
    drawings = tuple(without_companions(layer) for layer in scene.layers if layer.figure_id == figure_id)
    bare = replace(scene, background=None, layers=drawings, pieces=(), set_shadow=None)
    renderer.draw_picture(bare, Backdrop.TRANSPARENT)
    return np.asarray(renderer.read_picture()[..., 3] >= _HALF_OPAQUE)
