"""Which part of the canvas mirrors what of a cel, and the numbers of it as ``passes/mirrored.frag`` wants them."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil
from typing import Final

import numpy as np

from kagezou.geometry.box import Box, centred_offset
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.polygon import bounding_box
from kagezou.geometry.reflection import away_from_mirrored_eye, mirrored_region
from kagezou.geometry.shadow import Cast, cast_card, plane_coordinates
from kagezou.geometry.vectors import Matrix
from kagezou.io.images.reading import Matte
from kagezou.render.prepare.cast_uniforms import Frame
from kagezou.render.prepare.moved import moved_by
from kagezou.render.prepare.uniforms import Uniform
from kagezou.render.prepare.wave_uniforms import wave_uniforms
from kagezou.scene.filters import Water
from kagezou.scene.scene import PlacedDrawing, Reflection

_MOST_CELLS: Final = 4
"""Into how many cells a pixel is split at most, each way; where nothing shrinks, texels are seen as they are."""


@dataclass(frozen=True, slots=True, eq=False)
class MirrorTile:
    """One piece of the card in the ground.

    Parameters
    ----------
    box
        Canvas px.
    switches, uniforms
        Of ``passes/mirrored.frag``, but for the cel itself.
    sheet
        Tiles of one sheet continue one another, see `Cast`; others lie one over the other.
    """

    box: Box
    switches: frozenset[str]
    uniforms: dict[str, Uniform]
    sheet: int


@dataclass(frozen=True, slots=True, eq=False)
class _Moved:
    """The waves over a ground: how they move places of it, and how these are seen."""

    canvas_from_place: Matrix
    uniforms: dict[str, Uniform]
    reach_px: float

    @staticmethod
    def on(reflection: Reflection, water: Water) -> "_Moved":
        place = contact_plane(reflection.card, reflection.ground)
        ground_from_place = plane_coordinates(reflection.ground)[:2] @ place.world_from_plane()
        return _Moved(
            canvas_from_plane(reflection.camera, place),
            wave_uniforms(water, ground_from_place, water.anchor_px),
            water.reach_px,
        )

    def on_pixels(self, frame: Frame) -> dict[str, Uniform]:
        """Return all that the switch WAVES wants."""
        pixel_from_place = np.linalg.inv(frame.canvas_from_pixel) @ self.canvas_from_place
        place_from_pixel = np.linalg.inv(pixel_from_place)
        return {
            **self.uniforms,
            "u_place_from_pixel": place_from_pixel / np.abs(place_from_pixel).max(),
            "u_pixel_from_place": pixel_from_place / np.abs(pixel_from_place[2]).max(),
        }

    def margin_px(self, region: Matrix) -> float:
        """Return how far on the canvas a place of a region (N, 2) may be moved at most, about."""
        back: Matrix = np.asarray(np.linalg.inv(self.canvas_from_place), np.float64)
        stretch = 1 / max(min(_stretches(back, region)), 1e-3)
        return self.reach_px * stretch


def mirror_tiles(reflection: Reflection, cel: PlacedDrawing, matte: Matte, canvas: Box) -> Iterator[MirrorTile]:
    """Yield where a cel of a figure is mirrored; ``matte`` is the cel's own."""
    light = away_from_mirrored_eye(reflection.camera, reflection.ground)
    if light is None or matte.box is None:
        return
    figure = matte.box.moved(*centred_offset(canvas, matte.width_px, matte.height_px))
    moved = None if reflection.water is None else _Moved.on(reflection, reflection.water)
    for cast in cast_card(reflection.camera, reflection.ground, reflection.card, light):
        on_cel = cast if cel.placement is None else cast.of_moved(cel.placement)
        region = _region(on_cel, canvas, figure, moved)
        box = bounding_box(region)
        box = None if box is None else box.intersection(canvas)
        if box is not None:
            frame = Frame(region)
            waves = frozenset() if moved is None else frozenset({"WAVES"})
            cells = 1 if reflection.is_hard else _MOST_CELLS
            uniforms = _uniforms(on_cel, figure, frame, cells) | ({} if moved is None else moved.on_pixels(frame))
            hard = frozenset({"HARD"} if reflection.is_hard else ())
            yield MirrorTile(box, frozenset({f"LIMITS {len(cast.limits)}"}) | waves | hard, uniforms, cast.sheet)


def _region(cast: Cast, canvas: Box, figure: Box, moved: _Moved | None) -> Matrix:
    # What lies between the outermost texels and nothing reaches half a texel further.
    around = figure.grown(1)
    region = mirrored_region(cast, cast.region(canvas, around))
    if moved is None:
        return region
    wide = max(canvas.width, canvas.height)
    seen = mirrored_region(cast, cast.region(canvas.grown(wide), around))
    if len(seen) == 0:
        return region
    return mirrored_region(cast, cast.region(canvas, around, 1.0 + moved.margin_px(seen)))


def _uniforms(cast: Cast, figure: Box, frame: Frame, most_cells: int) -> dict[str, Uniform]:
    pixel = frame.canvas_from_pixel
    texel_from_pixel = moved_by(-figure.left, -figure.top) @ cast.art_from_canvas @ pixel
    shrunk = max(_stretches(moved_by(-figure.left, -figure.top) @ cast.art_from_canvas, frame.region))
    found: dict[str, Uniform] = {
        "u_origin_px": tuple(float(each) for each in frame.origin),
        "u_texel_from_pixel": texel_from_pixel / np.abs(texel_from_pixel[2]).max(),
        "u_cells": min(max(ceil(shrunk - 1e-3), 1), most_cells),
        "u_side": cast.side @ pixel,
        "u_horizon": cast.horizon @ pixel,
    }
    if len(cast.limits):
        found["u_limits"] = np.pad(cast.limits @ pixel, ((0, 0), (0, 1)))
    return found


def _stretches(homography: Matrix, region: Matrix) -> list[float]:
    """Return the greatest stretch of a homography (3, 3) at the corners (N, 2) of a region."""
    found = []
    for x, y in region:
        h = homography @ (x, y, 1.0)
        slopes = (homography[:2, :2] - np.outer(h[:2] / h[2], homography[2, :2])) / h[2]
        found.append(float(np.linalg.norm(slopes, 2)))
    return found
