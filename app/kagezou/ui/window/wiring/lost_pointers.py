"""A drag is over when its pen or its window goes away: whatever lifts then comes to somebody else."""

from PySide6.QtWidgets import QWidget

from kagezou.ui.widgets.range_slider import RangeSlider
from kagezou.ui.widgets.scrub_field import ScrubField
from kagezou.ui.window.parts import Parts


def let_go_of_all(parts: Parts, window: QWidget) -> None:
    """End every drag under way: numbers and handles as they are, keys, drawings and curves as they were."""
    parts.viewport.let_go()
    lanes, curves = parts.time.timeline.lanes, parts.curves.editor
    for controller in (lanes.controller, lanes.drawings):
        if controller.is_busy:
            controller.cancel()
    if curves is not None and curves.graph.controller.is_down:
        curves.graph.controller.cancel()
        if parts.bridge.is_scrubbed:
            parts.bridge.let_pass(on=False)
    for field in window.findChildren(ScrubField):
        field.end_drag()
    for slider in window.findChildren(RangeSlider):
        slider.setSliderDown(False)
