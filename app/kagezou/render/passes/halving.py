"""The pass that makes a picture of a shadow half as fine, again and again."""

from kagezou.geometry.box import Box
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import GrowingTarget
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.prepare.shadow_levels import ShadowLevels, halved

_ALONG_V = frozenset({"ALONG_V"})


class HalvingPass:
    """Fills the coarser levels of a shadow from the finest, each from the one before."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._programs = Variants("common/box.vert", "passes/halve.frag")
        self._aside = GrowingTarget(Format.ALPHA16)

    def fill(self, shadow: Target, levels: ShadowLevels, span: tuple[int, int], held: Box | None) -> Box | None:
        """Fill some levels, which are empty before, each from the one before it.

        Parameters
        ----------
        shadow, levels
            What holds them, and how.
        span
            The level that is there, and the last one that is to be filled.
        held
            Where the one that is there may hold anything, px from its corner; returned is that of the last.
        """
        first, last = span
        aside = self._aside.at_least(levels.width // 2, levels.height)
        for level in range(first, last):
            if held is None:
                break
            source, goal = levels.box_of(level), levels.box_of(level + 1)
            part = halved(held).intersection(Box(0, 0, goal.width, goal.height))
            if part is not None:
                across = Box(part.left, held.top, part.right, held.bottom)
                here = (source.left, source.top)
                self._halve((shadow, here), (aside, (0, 0)), across, along_v=False, known=(held.left, held.right))
                there = (goal.left, goal.top)
                self._halve((aside, (0, 0)), (shadow, there), part, along_v=True, known=(held.top, held.bottom))
            held = part
        return held

    def close(self) -> None:
        """Give the memory back."""
        self._programs.close()
        self._aside.close()

    def _halve(
        self,
        source: tuple[Target, tuple[int, int]],
        goal: tuple[Target, tuple[int, int]],
        part: Box,
        *,
        along_v: bool,
        known: tuple[int, int],
    ) -> None:
        """Halve along one axis; ``source`` and ``goal`` are targets and where a level begins in them."""
        (read, corner), (drawn, first) = source, goal
        box = part.moved(*first)
        drawn.bind(box)
        read.texture.bind(0)
        self._programs[_ALONG_V if along_v else frozenset()].use(
            {
                "u_target_size_px": drawn.size_px,
                "u_source": 0,
                "u_corner": (float(corner[0]), float(corner[1])),
                "u_first": (float(first[0]), float(first[1])),
                "u_known": (float(known[0]), float(known[1] - 1)),
            }
        )
        self._boxes.draw_one(box)
