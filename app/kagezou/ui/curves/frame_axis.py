"""The axis of time under the curves."""

from collections.abc import Sequence

import pyqtgraph as pg

from kagezou.animation.timecode import sheet_text
from kagezou.document.frame_numbers import number_of
from kagezou.ui.system.bridge import Bridge


class FrameAxis(pg.AxisItem):
    """Whole frames, and below them seconds and frames where there is room."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__("bottom")
        self._bridge = bridge

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        canvas = self._bridge.document.canvas
        del scale
        if spacing < 1:
            return ["" for _ in values]
        frames = [int(value) for value in values]
        return [
            f"{number_of(canvas, frame)}  ({sheet_text(frame, canvas.frame_rate)})" if frame >= 1 else ""
            for frame in frames
        ]
