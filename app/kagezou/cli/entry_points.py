"""What the command line is handed by whoever starts it, because it must not know it."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # at run time the room of OpenGL is imported only by the verbs that draw
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
    """

    open_context: "OpenContext"
    open_window: Callable[[Path | None], int]
    has_display: bool
