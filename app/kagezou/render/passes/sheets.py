"""The pass that lays the shadows on the sheets of a chart over that on the ground."""

import numpy as np

from kagezou.geometry.box import Box, around
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.mattes import PlacedMatte
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.scratches import GrowingTarget
from kagezou.render.gpu.targets import Format, Target
from kagezou.render.passes.cast import CastPass, Window
from kagezou.render.prepare.filter_job import BlurView, Chart, FilterJob, beyond_of
from kagezou.render.prepare.sheet_slots import SheetSlot, SheetSlots, sheet_slots
from kagezou.render.prepare.strip_uniforms import STRIPS, slot_uniforms


class SheetsPass:
    """Casts on all sheets of a chart aside, each in its own slot, and lays them together.

    Parameters
    ----------
    boxes, caster
        What draws and casts.
    crop
        The programs that take parts of a picture to other places; closed by whoever made them.
    """

    def __init__(self, boxes: Boxes, caster: CastPass, crop: Variants) -> None:
        self._boxes = boxes
        self._caster = caster
        self._crop = crop
        self._aside = GrowingTarget(Format.ALPHA16)

    def close(self) -> None:
        """Give the memory back."""
        self._aside.close()

    def lay(
        self, asked: tuple[FilterJob, PlacedMatte, Chart], goal: tuple[Target, Box | None], window: Window
    ) -> Box | None:
        """Cast the shadow on each sheet of a chart, and lay what is uppermost over the ground.

        Parameters
        ----------
        asked
            The job and its drawing, and the chart.
        goal
            Where the ground is, and the box that may hold any of its shadow; returned is that of all.
        window
            Onto the picture of the chart, in u and v of the blur.
        """
        assert window.canvas_from_target is not None
        (job, matte, chart), (whole, held) = asked, goal
        stretch = np.eye(3)
        stretch[:2, :2] = job.ground_from_blurred
        picture_from_flat: Matrix = np.asarray(np.linalg.inv(stretch @ window.canvas_from_target), np.float64)
        outlines = job.development.outlines(chart.number, beyond_of(job, chart))
        for together in sheet_slots(outlines, picture_from_flat, window.box):
            aside = self._aside.at_least(together.box.width, together.box.height)
            aside.clear(together.box)
            cast = [self._cast(job, matte, slot, (aside, window)) for slot in together.slots]
            held = around(held, *cast)
            # Where neither sheets nor the ground have any shadow there is nothing to be laid.
            if held is not None:
                self._lay(together, aside, whole, held)
        return held

    def _cast(self, job: FilterJob, matte: PlacedMatte, slot: SheetSlot, goal: tuple[Target, Window]) -> Box | None:
        """Cast the shadow on a sheet into its slot; return the box of the picture that may hold any."""
        aside, window = goal
        view = BlurView.of_sheet(job, slot.sheet, window.box)
        x, y = slot.shift
        own = window.moved(slot.box, (x, y)).seen_through(view.canvas_from_blurred)
        box = self._caster.unite(view.cast, matte, aside, own)
        return box and box.moved(-x, -y)

    def _lay(self, together: SheetSlots, aside: Target, whole: Target, held: Box) -> None:
        whole.bind(held)
        aside.texture.bind(0)
        uniforms = slot_uniforms(together.slots)
        self._crop[STRIPS].use({"u_target_size_px": whole.size_px, "u_source": 0, **uniforms})
        self._boxes.draw_triangles(together.triangles)
