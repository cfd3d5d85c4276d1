"""Small pictures of a figure: head, feet and shadow whole, also where the shadow leaves the canvas."""

from collections.abc import Sequence
from typing import Final

import numpy as np

from kagezou.document.model import Document
from kagezou.document.roomier import roomier
from kagezou.document.scaling import scaled
from kagezou.export.cut_measures import ShadowSeen, shadow_over_cut
from kagezou.geometry.box import Box, around, centred_offset
from kagezou.geometry.placement import around_placed, canvas_from_centred
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import Steps
from kagezou.io.images.smaller_cels import SmallerCels
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from kagezou.scene.placing import figure_box
from kagezou.scene.scene import LayerScene, Scene

_REACH: Final = 1.5
"""How far beyond the canvas a shadow is followed, in heights of the figure; a low sun's has no end."""

_MOST_PX: Final = 16384
_SEEN: Final = 8
"""The least alpha of a shadow, of 255, that counts."""


class Portraits:
    """Draws one figure of a cut in a frame, with the context that is current when it is made and used.

    Documents that are drawn have the canvas, the layers and the drawings of the one it was made for.

    Parameters
    ----------
    document
        The cut.
    figure_id
        The layer of the figure.
    frame
        From 1.
    side_px
        How large a portrait is needed: drawings much larger are made smaller first.
    """

    def __init__(self, document: Document, figure_id: str, frame: int, side_px: int) -> None:
        self._figure_id, self._frame = figure_id, frame
        self._divisor, self._margins = _fineness(document.canvas.box, figure_box(document, figure_id, frame), side_px)
        self._cels: CelCache | SmallerCels = CelCache()
        if self._divisor > 1:
            larger = roomier(document, *self._margins).canvas
            self._cels = SmallerCels(CelCache(), larger.box, self._divisor)
        self._renderer = Renderer(self._cels, divisor=self._divisor)

    def box(self, document: Document, frame: int | None = None) -> Box:
        """Return what holds the figure, its shadow and its reflection; the canvas where nothing is seen.

        In px of the portraits' own canvas.

        ``frame`` is another one than that of the portraits.
        """
        scene = evaluate(self._smaller(document), self._frame if frame is None else frame)
        shadows = (self._renderer.shadow(scene, layer) for layer in scene.layers if layer.id == self._figure_id)
        seen = [_seen(image.alpha, image.box) for image in shadows]
        mirrored = (each for each in scene.layers if each.id == self._figure_id and each.reflection is not None)
        seen += [_seen(self._renderer.reflection(scene, each)[..., 3], scene.canvas) for each in mirrored]
        found = around(
            *seen, *(self._cel_box(scene, each) for each in scene.layers if each.figure_id == self._figure_id)
        )
        return scene.canvas if found is None else found

    def draw(self, document: Document, place: Box, backdrop: Backdrop, frame: int | None = None) -> Steps:
        """Return the square around a box, (H, H, 4), white where there is no canvas; ``frame`` as for :meth:`box`."""
        self._renderer.draw_picture(
            evaluate(self._smaller(document), self._frame if frame is None else frame), backdrop
        )
        return square_of(self._renderer.read_picture(), place)

    def over_cut(self, document: Document, frames: Sequence[int]) -> tuple[ShadowSeen, ...]:
        """Return what is seen of the figure's shadow on frames, px of the portraits' own canvas."""
        return shadow_over_cut(self._smaller(document), self._figure_id, frames, self._renderer)

    def close(self) -> None:
        """Give the memory back; the context must be current."""
        self._renderer.close()

    def _cel_box(self, scene: Scene, layer: LayerScene) -> Box | None:
        """Return where the opaque part of a layer's drawing lies."""
        if layer.drawing is None:
            return None
        cel = self._cels.cel(layer.drawing.source)
        if cel.matte.box is None:
            return None
        height, width = cel.rgba.shape[:2]
        box = cel.matte.box.moved(*centred_offset(scene.canvas, width, height))
        placement = layer.drawing.placement
        return box if placement is None else around_placed(box, canvas_from_centred(placement))

    def _smaller(self, document: Document) -> Document:
        return scaled(roomier(document, *self._margins), self._divisor)


def square_of(picture: Steps, place: Box) -> Steps:
    """Return the square in whose middle a box lies, (H, H, 4), a little larger than it; white beyond the picture."""
    side = max(place.width, place.height)
    side += max(2, side // 12)
    left, top = (place.left + place.right - side) // 2, (place.top + place.bottom - side) // 2
    square = np.full((side, side, 4), np.iinfo(picture.dtype).max, picture.dtype)
    there = Box(left, top, left + side, top + side).intersection(Box(0, 0, picture.shape[1], picture.shape[0]))
    if there is not None:
        rows, columns = slice(there.top, there.bottom), slice(there.left, there.right)
        square[there.top - top : there.bottom - top, there.left - left : there.right - left] = picture[rows, columns]
    return square


def _fineness(canvas: Box, figure: Box, side_px: int) -> tuple[int, tuple[int, int]]:
    """Return by how much the cut is made smaller, and the margins, px of the cut, with which that goes up."""
    reach = round(_REACH * figure.height)
    for divisor in range(max(figure.height // side_px, 1), 1, -1):
        margins = tuple(_margin(length, reach, divisor) for length in (canvas.width, canvas.height))
        if None not in margins:
            across, down = margins
            return divisor, (across or 0, down or 0)
    return 1, (min(reach, (_MOST_PX - canvas.width) // 2), min(reach, (_MOST_PX - canvas.height) // 2))


def _margin(length: int, reach: int, divisor: int) -> int | None:
    """Return the least margin from ``reach`` on with which a length can be divided; None where there is none."""
    fitting = (margin for margin in range(reach, reach + divisor) if (length + 2 * margin) % divisor == 0)
    return next((margin for margin in fitting if length + 2 * margin <= _MOST_PX), None)


def _seen(alpha: np.ndarray[tuple[int, ...], np.dtype[np.uint8 | np.uint16]], box: Box) -> Box | None:
    """Return the box of what is seen of a shadow with its alpha in a box; None where nothing is."""
    rows, columns = (np.flatnonzero((alpha >= _SEEN).any(axis=axis)) for axis in (1, 0))
    if not rows.size:
        return None
    left, top = box.left + int(columns[0]), box.top + int(rows[0])
    return Box(left, top, box.left + int(columns[-1]) + 1, box.top + int(rows[-1]) + 1)
