"""The preview's resolution: as chosen, or lower only while something is dragged and frames would be late."""

from itertools import count

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from pytestqt.qtbot import QtBot

from kagezou.document.edits import set_canvas
from kagezou.document.model import Canvas
from kagezou.ui.viewport import resolution
from kagezou.ui.viewport.resolution import FULL, Pace, PreviewFineness, Resolution
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import drag, move, picture, place_of


def divisor_of(viewport: Viewport) -> int:
    assert viewport.frame_painter is not None
    return viewport.frame_painter.divisor


def test_it_goes_down_only_where_the_last_frames_were_late_and_only_while_moving() -> None:
    pace = Pace()
    assert pace.next(moving=True) == PreviewFineness(1, in_haste=True)
    pace.took(1, 3 * resolution.DUE_S)
    assert pace.next(moving=True).divisor == 1, "one late frame may have brought its drawings"
    pace.took(1, 3 * resolution.DUE_S)
    assert pace.next(moving=True).divisor == 2
    assert pace.next(moving=False) == FULL
    for _ in range(3):
        pace.took(2, 2 * resolution.DUE_S)
    assert pace.next(moving=True).divisor == 4
    for _ in range(3):
        pace.took(1, resolution.DUE_S / 2)
    assert pace.next(moving=True).divisor == 1
    pace.forget()
    assert pace.next(moving=True).divisor == 1


@pytest.mark.parametrize(("chosen", "divisor"), [(Resolution.FULL, 1), (Resolution.HALF, 2), (Resolution.QUARTER, 4)])
def test_a_chosen_resolution_holds_moving_or_not(chosen: Resolution, divisor: int) -> None:
    pace = Pace()
    pace.resolution = chosen
    for _ in range(4):
        pace.took(1, 9 * resolution.DUE_S)
    assert pace.next(moving=True) == pace.next(moving=False) == PreviewFineness(divisor)


def test_a_drag_that_is_late_is_drawn_coarser_and_refined_at_rest(qtbot: QtBot, walking: MainWindow) -> None:
    viewport = walking.parts.viewport
    seen: list[int] = []
    viewport.divisor_changed.connect(seen.append)
    before = picture(viewport)
    for _ in range(3):
        viewport.pace.took(1, 9 * resolution.DUE_S)

    start = place_of(viewport, "light.lamp")
    qtbot.mousePress(viewport, Qt.MouseButton.LeftButton, pos=start)
    steps = count(1)

    def is_coarser_after_a_step() -> bool:
        # Late it stays, however quick this machine is meanwhile.
        viewport.pace.took(1, 9 * resolution.DUE_S)
        move(viewport, start + QPoint(next(steps) % 40, 5), Qt.MouseButton.LeftButton)
        viewport.grab()
        return divisor_of(viewport) > 1

    # The smaller drawings are made beside the first steps.
    qtbot.waitUntil(is_coarser_after_a_step)
    assert divisor_of(viewport) in (2, 4)
    qtbot.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=start)

    qtbot.waitUntil(lambda: divisor_of(viewport) == 1)
    assert picture(viewport).shape == before.shape
    qtbot.waitUntil(lambda: len(seen) > 1 and seen[-1] == 1)


def test_a_drag_that_keeps_up_stays_at_full_resolution(qtbot: QtBot, walking: MainWindow) -> None:
    drag(qtbot, walking.parts.viewport, "light.lamp", QPoint(30, 10))
    walking.parts.viewport.grab()
    assert divisor_of(walking.parts.viewport) == 1


def test_a_chosen_resolution_is_shown_remembered_and_never_exported(walking: MainWindow, qtbot: QtBot) -> None:
    full = picture(walking.parts.viewport)
    half = next(each for each in walking.parts.menus.resolutions.actions() if each.text() == "Half")

    half.trigger()
    small = picture(walking.parts.viewport)

    assert small.shape == (full.shape[0] // 2, full.shape[1] // 2, 4)
    wide = small.repeat(2, axis=0).repeat(2, axis=1).astype(int)
    assert float(np.abs(wide - full).mean()) < 6
    qtbot.waitUntil(lambda: "1/2" in [label.text() for label in walking.parts.status.labels])
    assert walking.parts.settings.word("resolution", "") == "half"


def test_a_canvas_that_cannot_be_divided_is_drawn_whole(walking: MainWindow) -> None:
    bridge = walking.parts.open_project.bridge
    walking.parts.viewport.show_resolution(Resolution.QUARTER)
    bridge.session.edit("Odd", set_canvas(bridge.document, Canvas(241, 199)))
    assert picture(walking.parts.viewport).shape == (199, 241, 4)
    bridge.session.mark_saved()
