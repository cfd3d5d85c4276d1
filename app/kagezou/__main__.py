"""The front door: the window without a verb, the command line with one.

The only place that knows both.
"""

import gc
import logging
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

from kagezou.cli import main as command_line
from kagezou.cli.arguments_file import given_words
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.streams import open_closed_streams
from kagezou.cli.terminal import speak_plainly, tell
from kagezou.contexts import avoid_dead_compositor, has_display, open_context
from kagezou.errors import GraphicsProblem, Problem
from kagezou.io.files.crash_reports import watching_for_fatal_ends
from kagezou.own_process import ran_as_child

if TYPE_CHECKING:  # neither is needed to open the window
    from kagezou.cli.bench.window import Answered
    from kagezou.document.model import Document

PROJECT_SUFFIXES = (".kage", ".xdts", ".tdts", ".sts", ".psd", ".psb", ".oca")
"""What the window opens: projects, and the timesheets and files of layers that drawing programs hand over."""


_UNCOLLECTED_AT_START = 200_000
"""So many new objects before Python looks for circles of them: by its own 700 it does little else while importing."""

_UNCOLLECTED_IN_WINDOW = 50_000
"""In a window a look at more of them would be felt while something is dragged."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Choose the door and return the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    open_closed_streams()
    if ran_as_child(words):
        return 0
    _start_lean()
    speak_plainly()
    try:
        words = given_words(words)
    except Problem as problem:
        tell(str(problem))
        return problem.exit_code
    with watching_for_fatal_ends(words):
        return _opened(words)


def _opened(words: Sequence[str]) -> int:
    """Go through the door that the words are for."""
    if not words:
        return open_window(None)
    if len(words) == 1 and words[0].lower().endswith(PROJECT_SUFFIXES):
        return open_window(Path(words[0]))
    is_seen = has_display()
    ways = EntryPoints(open_context, open_window, is_seen, measure_window=measure_window if is_seen else None)
    return command_line.run(words, ways)


def _start_lean() -> None:
    """Spare what takes long where a frame is made within a second."""
    gc.set_threshold(_UNCOLLECTED_AT_START)
    # Threads for matrices, which numpy starts when it is imported; here they are of three rows.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def _go_on_lean() -> None:
    """Leave alone what has been imported for a window, which stays, and look at the new more often."""
    gc.freeze()
    gc.set_threshold(_UNCOLLECTED_IN_WINDOW)


def program() -> NoReturn:
    """Be the program: do what the words say and end the process.

    What Python does at its end, taking every object apart, takes as long as several frames; where no window was open,
    nothing waits for it.
    """
    code = main()
    if "PySide6" not in sys.modules:
        logging.shutdown()
        with suppress(OSError, ValueError):  # a reader that is gone has been told of already
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(code)
    sys.exit(code)


def window(arguments: Sequence[str] | None = None) -> int:
    """Open the window from a desktop, where there may be no console; with a file that was double-clicked, if any."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    return main(words[:1])


def open_window(project: Path | None) -> int:
    """Open the window; where there cannot be one, say so in one sentence."""
    if not has_display():
        tell("there is no display for the window; the command line works without one (see kagezou --help)")
        return GraphicsProblem.exit_code
    avoid_dead_compositor()
    try:
        from kagezou.ui.application import run
    except ImportError as error:
        tell(f"the window cannot be opened: {error} (kagezou doctor says what is missing)")
        return GraphicsProblem.exit_code
    _go_on_lean()
    return run(project, make_demo=make_demo)


def measure_window(walk: "Document", crowd: "Document") -> tuple[str, "Sequence[Answered]"]:
    """Open the window and measure how it answers a hand."""
    from kagezou.ui.measuring.window_bench import measured

    _go_on_lean()
    return measured(walk, crowd)


def make_demo(folder: Path, progress: Callable[[int, int], None]) -> Path:
    """Make the demo's files for the window and return its project."""
    from kagezou.cli.demo.stage import make_demo as make
    from kagezou.io.files.processors import processors

    return make(folder, processors(), progress).project


if __name__ == "__main__":
    program()
