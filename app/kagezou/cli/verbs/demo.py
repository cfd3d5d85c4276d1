"""``kagezou demo``: a small project to look at, made and rendered by the program itself."""

import sys
from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.reporting import verdict
from kagezou.cli.terminal import give, tell
from kagezou.io.files.processors import processors

DESCRIPTION = """\
Draw a small animated character, make a project of it, render its shadow layers and the finished pictures, and say
where they are. Opens the window with it where there is a display and someone is watching."""
EXAMPLES = """\
  kagezou demo                     into the folder kagezou-demo
  kagezou demo /tmp/look --no-window
"""
FOLDER = Path("kagezou-demo")


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER, metavar="DIR", help=f"where to ({FOLDER})")
    window = parser.add_mutually_exclusive_group()
    window.add_argument("--window", action="store_true", default=None, help="open the window in any case")
    window.add_argument("--no-window", dest="window", action="store_false", help="do not open the window")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Make the demo, render it, and show it."""
    from kagezou.cli.demo.stage import make_demo
    from kagezou.export.frames import export_frames
    from kagezou.export.request import ExportRequest
    from kagezou.io.files.faults import shown

    folder: Path = options.folder.absolute()
    workers = processors()
    with entry_points.line("drawing") as line:
        demo = make_demo(folder, workers, line.update)
    request = ExportRequest(folder / "render", composite=True, workers=workers)
    with stopping_gently() as interruption, entry_points.line("rendering") as line:
        summary = export_frames(demo.document, request, entry_points.open_context, line.update, interruption.is_set)
    code = verdict(summary, interruption)
    if code:
        return code
    give(f"project    {shown(demo.project)}")
    for target in summary.folders:
        give(f"frames     {shown(target)}")
    sys.stdout.flush()
    if not _window_is_wanted(options.window, entry_points):
        tell(f"to open it in the window: kagezou {shown(demo.project)}")
        return 0
    tell("opening the window; close it to come back")
    return entry_points.open_window(demo.project)


def _window_is_wanted(wish: bool | None, entry_points: EntryPoints) -> bool:  # noqa: FBT001 - three-valued: yes, no, as it fits
    if wish is not None:
        return wish
    return entry_points.has_display and (sys.stdin.isatty() or sys.stdout.isatty())
