"""The pass that mirrors a figure in the ground."""

from collections.abc import Sequence
from itertools import groupby

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.io.images.reading import Cel
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target, Texture
from kagezou.render.passes.cel_textures import CelTextures
from kagezou.render.passes.fade_and_tip import distance_uniforms, unit_rgb
from kagezou.render.prepare.mirror_tiles import MirrorTile, mirror_tiles
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import Reflection

_COLOR_BUDGET_BYTES = 128 << 20


class MirrorPass:
    """Draws the cels of a figure as the ground mirrors them, laid over one another there as they are in the picture."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._mirrored = Variants("common/box.vert", "passes/mirrored.frag")
        self._look = Variants("common/box.vert", "passes/mirror_look.frag")
        self._cels = CelTextures(_COLOR_BUDGET_BYTES)
        self._scratches = Scratches()

    def draw(self, reflection: Reflection, cels: Sequence[Cel], ground: Texture | None, target: Target) -> Box | None:
        """Draw a reflection into an empty target and return where; None where nothing is mirrored.

        Parameters
        ----------
        reflection
            What is mirrored, and its look.
        cels
            Its cels, decoded, from the bottom.
        ground
            The part of each pixel in which the ground is seen; None where nothing hides it.
        target
            Of the canvas' size; gets straight colour and alpha.
        """
        whole = self._scratches.like("whole", target)
        drawn = [
            box
            for placed, cel in zip(reflection.figure, cels, strict=True)
            for box in self._lay(list(mirror_tiles(reflection, placed, cel.matte, target.box)), cel, whole)
        ]
        box = around(*drawn)
        if box is not None:
            self._color(reflection, whole, ground, target, box)
            whole.clear(box)
        return box

    def close(self) -> None:
        """Give the memory back."""
        self._scratches.close()
        self._cels.close()
        self._look.close()
        self._mirrored.close()

    def _lay(self, tiles: Sequence[MirrorTile], cel: Cel, whole: Target) -> list[Box]:
        """Lay a mirrored cel over what is there: what continues one another adds up aside first."""
        sheet = self._scratches.like("sheet", whole)
        drawn = []
        for _, together in groupby(sorted(tiles, key=lambda each: each.sheet), key=lambda each: each.sheet):
            parts = list(together)
            for part in parts:
                self._draw(part, cel, sheet)
            box = around(*[part.box for part in parts])
            assert box is not None
            self._put_over(sheet, whole, box)
            sheet.clear(box)
            drawn.append(box)
        return drawn

    def _draw(self, tile: MirrorTile, cel: Cel, sheet: Target) -> None:
        texture = self._cels.texture(cel)
        sheet.bind(tile.box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        texture.bind(0)
        self._mirrored[tile.switches].use({"u_target_size_px": sheet.size_px, "u_cel": 0, **tile.uniforms})
        self._boxes.draw_one(tile.box)

    def _put_over(self, sheet: Target, whole: Target, box: Box) -> None:
        whole.bind(box)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA)
        sheet.texture.bind(0)
        self._look[frozenset({"AS_IT_IS"})].use({"u_target_size_px": whole.size_px, "u_mirrored": 0})
        self._boxes.draw_one(box)

    def _color(self, reflection: Reflection, whole: Target, ground: Texture | None, target: Target, box: Box) -> None:
        switches: set[str] = set()
        uniforms: dict[str, Uniform] = {
            "u_target_size_px": target.size_px,
            "u_mirrored": 0,
            "u_color": unit_rgb(reflection.color),
            "u_tone": reflection.tone,
            "u_opacity": reflection.opacity,
        }
        if reflection.fade is not None:
            switches.add("FADING")
            place = contact_plane(reflection.card, reflection.ground)
            place_from_canvas = np.linalg.inv(canvas_from_plane(reflection.camera, place))
            uniforms |= {"u_fade_px": reflection.fade.range_px, "u_fade_curve": reflection.fade.curve}
            uniforms |= distance_uniforms(place_from_canvas[1], place_from_canvas[2], box)
        target.bind(box)
        whole.texture.bind(0)
        if ground is not None:
            switches.add("BEHIND_PIECES")
            ground.bind(1)
            uniforms["u_ground"] = 1
        self._look[frozenset(switches)].use(uniforms)
        self._boxes.draw_one(box)
