"""A shadow as an image of its own: covered parts times opacity, in the shadow's colour, read back."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from kagezou.geometry.box import Box
from kagezou.io.images.reading import Steps
from kagezou.io.images.writing import ShadowImage
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import check
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.fade_and_tip import look_uniforms, unit_rgb
from kagezou.render.prepare.mixing import Laid, mixed
from kagezou.scene.scene import ShadowCast, ShadowLook
from kagezou.scene.uniting import united_look

_DEPTHS = {8: np.uint8, 16: np.uint16}
_MOST_COVERED = 65535

Drawn: TypeAlias = tuple[Target, Box]
"""Covered parts, 16 bit, and the box outside of which there are none."""


@dataclass(frozen=True, slots=True, eq=False)
class Coloring:
    """How covered parts are coloured.

    Attributes
    ----------
    look
        Colour, opacity and how they change over the shadow.
    cast
        What the distance over which they change is counted from; None where they do not.
    measured
        That distance, where it was measured for every pixel.
    """

    look: ShadowLook
    cast: ShadowCast | None = None
    measured: Texture | None = None


class ShadowImages:
    """Makes images of shadows, with targets of its own."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._programs = Variants("common/box.vert", "common/shade.frag")
        self._targets: dict[Format, Target] = {}

    def image(self, canvas: Box, drawn: Drawn | None, coloring: Coloring, depth: int) -> ShadowImage:
        """Return a shadow as straight alpha of one colour, or with colours of its own where it has a tip.

        Parameters
        ----------
        canvas
            Its size, canvas px.
        drawn
            What is covered; None for an empty shadow.
        coloring
            How it is coloured.
        depth
            Bits of alpha, 8 or 16.
        """
        width, height, look = canvas.width, canvas.height, coloring.look
        if drawn is None:
            return ShadowImage(width, height, look.color, np.zeros((0, 0), _DEPTHS[depth]), Box(0, 0, 0, 0))
        coverage, box = drawn
        switches, uniforms = look_uniforms(coloring.cast, look, box, coloring.measured)
        if not switches:
            covered = coverage.read(box)
            check("drawing a shadow")
            return ShadowImage(width, height, look.color, _alpha_of(covered, look.opacity, depth), box)
        forms = (Format.RGBA8, Format.RGBA16) if look.tip else (Format.ALPHA8, Format.ALPHA16)
        target = self._target_of(canvas, forms[depth != 8])
        if look.tip:
            uniforms["u_color"] = unit_rgb(look.color)
        target.bind(box)
        coverage.texture.bind(0)
        self._programs[switches].use({"u_target_size_px": target.size_px, "u_coverage": 0, **uniforms})
        self._boxes.draw_one(box)
        shown = target.read(box)
        check("drawing a shadow")
        if look.tip:
            return ShadowImage(width, height, look.color, shown[..., 3], box, shown[..., :3])
        return ShadowImage(width, height, look.color, shown, box)

    def united(self, canvas: Box, drawn: Drawn | None, look: ShadowLook, depth: int) -> ShadowImage:
        """Return shadows that `UnitePass` has made one, as :meth:`image` does a single one of their look."""
        if drawn is None or look.tip is None:
            return self.image(canvas, drawn, Coloring(united_look(look)), depth)
        target, box = drawn
        taken = target.read(box) / np.float32(_MOST_COVERED)
        check("drawing a shadow")
        covered = taken[..., 3:]
        color = np.where(covered > 0, 1 - taken[..., :3] / np.where(covered > 0, covered, 1), 0)
        most, form = (1 << depth) - 1, _DEPTHS[depth]
        alpha, shown = (np.rint(each * most).astype(form) for each in (covered[..., 0] * look.opacity, color))
        return ShadowImage(canvas.width, canvas.height, look.color, alpha, box, shown)

    def mixed(
        self, canvas: Box, shades: Sequence[tuple[Drawn | None, ShadowLook]], depth: int, *, multiply: bool
    ) -> ShadowImage:
        """Return one of the two layers of shadows, at least one, from the lowest up; see `mixed`."""
        finest = depth if len(shades) == 1 else 16
        laid = [Laid(self.image(canvas, drawn, Coloring(look), finest), look.multiply) for drawn, look in shades]
        return mixed(laid, multiply=multiply, depth=depth)

    def close(self) -> None:
        """Give the memory back."""
        for target in self._targets.values():
            target.close()
        self._programs.close()

    def _target_of(self, canvas: Box, form: Format) -> Target:
        target = self._targets.get(form)
        if target is not None and target.box != canvas:
            target.close()
            target = None
        if target is None:
            target = self._targets[form] = Target(canvas.width, canvas.height, form)
        return target


def _alpha_of(covered: Steps, opacity: float, depth: int) -> Steps:
    """Return covered parts (h, w) 16 bit times an opacity that is the same everywhere, in a depth."""
    most = (1 << depth) - 1
    scaled = covered * np.float32(opacity * most / _MOST_COVERED)
    alpha: Steps = np.rint(scaled, out=scaled).astype(_DEPTHS[depth])
    return alpha
