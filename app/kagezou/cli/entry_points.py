"""What the command line is handed by whoever starts it, because it must not know it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.terminal import ProgressLine

if TYPE_CHECKING:  # at run time the room of OpenGL is imported only by the verbs that draw
    from kagezou.cli.bench.window import MeasureWindow
    from kagezou.cli.progress_file import ProgressFile
    from kagezou.render.gpu.context import OpenContext


@dataclass(frozen=True, slots=True)
class EntryPoints:
    """The ways out of the command line.

    Parameters
    ----------
    open_context
        Makes an OpenGL context on the calling thread.
    open_window
        Opens the window with a project and returns its exit code.
    has_display
        Whether a window could be seen.
    progress
        What a program that waits is told by; None where none does.
    measure_window
        Opens the window and measures it; None where there is no display.
    """

    open_context: "OpenContext"
    open_window: Callable[[Path | None], int]
    has_display: bool
    progress: "ProgressFile | None" = None
    measure_window: "MeasureWindow | None" = None

    def line(self, doing: str, unit: str | None = "frames") -> ProgressLine:
        """Return the line that tells how far something is, to whoever watches or waits; ``unit`` is what is counted."""
        return ProgressLine(doing, also=None if self.progress is None else self.progress.update, unit=unit)
