"""The front door: the window without a verb, the command line with one.

The only place that knows both, and so the place that says where an OpenGL context comes from.
"""

import gc
import os
import platform
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Self

from kagezou.cli import main as command_line
from kagezou.cli.arguments_file import given_words
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import PROGRAM, speak_plainly, tell
from kagezou.errors import GraphicsProblem, Problem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.render.gpu.context import GraphicsContext
    from kagezou.render.gpu.info import GraphicsInfo

PROJECT_SUFFIXES = (".kage", ".xdts", ".tdts", ".sts", ".psd", ".psb", ".oca")
"""What the window opens: projects, and the timesheets and files of layers that drawing programs hand over."""


_UNCOLLECTED = 50_000
"""So many new objects before Python looks for circles of them: by its own 700 it does little else while importing."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Choose the door and return the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    _start_lean()
    speak_plainly()
    try:
        words = given_words(words)
    except Problem as problem:
        tell(str(problem))
        return problem.exit_code
    if not words:
        return open_window(None)
    if len(words) == 1 and words[0].lower().endswith(PROJECT_SUFFIXES):
        return open_window(Path(words[0]))
    return command_line.run(words, EntryPoints(open_context, open_window, has_display()))


def _start_lean() -> None:
    """Spare what takes long where a frame is made within a second."""
    gc.set_threshold(_UNCOLLECTED)
    # Threads for matrices, which numpy starts when it is imported; here they are of three rows.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def window(arguments: Sequence[str] | None = None) -> int:
    """Open the window from a desktop, where there may be no console; with a file that was double-clicked, if any."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    # Without a console Python has no streams at all, and whatever is printed would be an error of its own.
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, Path(os.devnull).open("w", encoding="utf-8"))  # noqa: SIM115 - open to the very end
    return main(words[:1])


def has_display() -> bool:
    """Return whether a window could be seen here."""
    if platform.system() != "Linux":
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def open_window(project: Path | None) -> int:
    """Open the window; where there cannot be one, say so in one sentence."""
    if not has_display():
        tell("there is no display for the window; the command line works without one (see kagezou --help)")
        return GraphicsProblem.exit_code
    try:
        from kagezou.ui.application import run
    except ImportError as error:
        tell(f"the window cannot be opened: {error} (kagezou doctor says what is missing)")
        return GraphicsProblem.exit_code
    return run(project, make_demo=make_demo)


def make_demo(folder: Path, progress: Callable[[int, int], None]) -> Path:
    """Make the demo's files for the window and return its project."""
    from kagezou.cli.demo.stage import make_demo as make
    from kagezou.cli.processors import processors

    return make(folder, processors(), progress).project


def open_context() -> "GraphicsContext":
    """Return an OpenGL context without a window: EGL, or the window system's offscreen surface.

    Raises
    ------
    GraphicsProblem
        Neither is available.
    """
    from kagezou.render.gpu.context import open_headless_context

    try:
        return open_headless_context()
    except GraphicsProblem:
        if not has_display():
            raise
    return _WindowSystemContext()


class _WindowSystemContext:
    """A context on an offscreen surface of the window system, with the Qt application that such a surface needs."""

    def __init__(self) -> None:
        try:
            from PySide6.QtGui import QGuiApplication

            from kagezou.ui.system.offscreen_context import OffscreenSurface
        except ImportError as error:
            raise GraphicsProblem(
                Message("OpenGL is not available: the window's libraries cannot be loaded: {error}", error=error)
            ) from error
        self._application = None if QGuiApplication.instance() else QGuiApplication([PROGRAM])
        self._context = OffscreenSurface().open()

    @property
    def info(self) -> "GraphicsInfo":
        """What draws; the context must be current."""
        return self._context.info

    def __enter__(self) -> Self:
        """Make the context current on this thread."""
        self._context.__enter__()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Destroy the context; an application of our own gives way to the window's."""
        self._context.__exit__(kind, error, trace)
        if self._application is not None:
            self._application.shutdown()
            self._application = None


if __name__ == "__main__":
    sys.exit(main())
