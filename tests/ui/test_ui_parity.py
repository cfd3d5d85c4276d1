"""One frame by the window and by the command line: the same bytes (spec 7)."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from viewing import picture

from kagezou.io.encode import write_rgba
from kagezou.io.images import read_cel
from kagezou.tools.grounding import add_grounding
from kagezou.ui.main_window import MainWindow


def by_command_line(*arguments: str) -> None:
    """Run the program as a farm would: in a process of its own, with no display."""
    headless = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    subprocess.run([sys.executable, "-m", "kagezou", *arguments], check=True, env=headless)


def test_the_same_frame_by_window_and_by_command_line_is_the_same_bytes(walking: MainWindow, tmp_path: Path) -> None:
    ramp = np.zeros((200, 240, 4), np.uint8)
    ramp[..., 1] = np.arange(240)
    ramp[..., 3] = 255
    write_rgba(tmp_path / "ramp.png", ramp)
    desk = walking.desk
    desk.put_background(tmp_path / "ramp.png").at_once()
    document = desk.bridge.document
    for point in ((108.0, 169.0), (132.0, 166.0)):
        document = add_grounding(document, document.layers[0].id, 1, point)
    desk.bridge.session.edit("Ground", document)
    desk.save(tmp_path / "cut.kage")
    desk.bridge.session.go_to(3)
    shown = picture(walking.viewport)

    by_command_line("render", str(tmp_path / "cut.kage"), "-o", str(tmp_path / "out"), "--frames", "3", "--composite")
    written = read_cel(tmp_path / "out" / "composite" / "composite_0003.png").rgba
    assert np.array_equal(shown, written)
    assert not np.array_equal(shown[..., :3], ramp[..., :3])
