"""The axis of time under the curves."""

from collections.abc import Sequence

import pyqtgraph as pg

from kagezou.animation.timecode import sheet_text
from kagezou.ui.system.bridge import Bridge


class FrameAxis(pg.AxisItem):
    """Whole frames, and below them seconds and frames where there is room."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__("bottom")
        self._bridge = bridge

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        rate = self._bridge.document.canvas.frame_rate
        del scale
        if spacing < 1:
            return ["" for _ in values]
        return [f"{value:.0f}  ({sheet_text(int(value), rate)})" if value >= 1 else "" for value in values]
