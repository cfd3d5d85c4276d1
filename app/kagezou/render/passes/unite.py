"""The pass that unites shadows of one look before they are laid on a picture."""

from collections.abc import Iterable
from dataclasses import dataclass, replace

from kagezou.geometry.box import Box, around
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.gl import GL
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.passes.fade_and_tip import look_uniforms, unit_rgb
from kagezou.scene.scene import ShadowCast, ShadowLook

MOST_TAKEN = frozenset({"MOST_TAKEN"})
"""The switch of ``common/shade.frag`` and ``picture/lay.frag`` for united shadows of two colours."""


@dataclass(frozen=True, slots=True, eq=False)
class Member:
    """One of the shadows that unite.

    Attributes
    ----------
    coverage, box
        Its covered parts, of the canvas' size, and where they may be.
    cast
        What its distances are counted from.
    measured
        Its distances on a set, where they are known for every pixel.
    """

    coverage: Texture
    box: Box
    cast: ShadowCast
    measured: Texture | None


class UnitePass:
    """Unites shadows by maximum, in targets of its own."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._programs = Variants("common/box.vert", "common/shade.frag")
        self._targets: dict[Format, Target] = {}
        self._drawn: dict[Format, Box] = {}

    def unite(self, canvas: Box, members: Iterable[Member], look: ShadowLook) -> tuple[Target, Box]:
        """Return what shadows of one look take together, before opacity, and where; it stays until the next union.

        Each of the members, at least one, is drawn before the next is asked for.

        Without a tip that is the maximum of covered part times strength, 16 bit. With one, in which a shadow has
        another colour with every distance, it is per colour the maximum of what is taken from white, and in alpha that
        of covered part times strength.
        """
        form = Format.RGBA16 if look.tip else Format.ALPHA16
        target = self._cleared(canvas, form)
        whole = replace(look, opacity=1.0)
        drawn: Box | None = None
        for member in members:
            switches, uniforms = look_uniforms(member.cast, whole, member.box, member.measured)
            if look.tip:
                switches |= MOST_TAKEN
                uniforms["u_color"] = unit_rgb(look.color)
            target.bind(member.box)
            GL.glEnable(GL.GL_BLEND)
            GL.glBlendEquation(GL.GL_MAX)
            member.coverage.bind(0)
            self._programs[switches].use({"u_target_size_px": target.size_px, "u_coverage": 0, **uniforms})
            self._boxes.draw_one(member.box)
            drawn = around(drawn, member.box)
        assert drawn is not None
        self._drawn[form] = drawn
        return target, drawn

    def close(self) -> None:
        """Give the memory back."""
        for target in self._targets.values():
            target.close()
        self._programs.close()

    def _cleared(self, canvas: Box, form: Format) -> Target:
        target = self._targets.get(form)
        if target is not None and target.box != canvas:
            target.close()
            target = None
        if target is None:
            target = self._targets[form] = Target(canvas.width, canvas.height, form)
            self._drawn[form] = canvas
        target.clear(self._drawn[form])
        # A failure half-way leaves no one knows what.
        self._drawn[form] = canvas
        return target
