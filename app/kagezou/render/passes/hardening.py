"""The pass that makes every pixel of a shadow all shadow or none."""

from kagezou.geometry.box import Box
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.program import Program
from kagezou.render.gpu.scratches import Scratches
from kagezou.render.gpu.targets import Target


class HardeningPass:
    """Rounds covered parts to none or the whole."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._threshold = Program("common/box.vert", "passes/threshold.frag")
        self._copy = Program("common/box.vert", "common/shade.frag")
        self._scratches = Scratches()

    def harden(self, covered: Target, box: Box) -> None:
        """Round what lies in a box of covered parts; half a pixel and more counts as all of it."""
        rounded = self._scratches.like("rounded", covered)
        rounded.bind(box)
        covered.texture.bind(0)
        self._threshold.use({"u_target_size_px": rounded.size_px, "u_source": 0})
        self._boxes.draw_one(box)
        covered.bind(box)
        rounded.texture.bind(0)
        self._copy.use({"u_target_size_px": covered.size_px, "u_coverage": 0, "u_opacity": 1.0})
        self._boxes.draw_one(box)

    def close(self) -> None:
        """Give the memory back."""
        self._scratches.close()
        self._copy.close()
        self._threshold.close()
