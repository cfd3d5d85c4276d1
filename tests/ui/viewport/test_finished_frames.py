"""Finished frames: a cut that played once plays again without being drawn, until something in it changes."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QImage
from pytestqt.qtbot import QtBot

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.viewport.finished_frames import FinishedFrames
from kagezou.ui.viewport.viewport import Viewport
from kagezou.ui.window.main_window import MainWindow
from tests.ui.conftest import FRAMES
from tests.ui.viewing import picture, write_garbage


def image() -> QImage:
    made = QImage(QSize(10, 10), QImage.Format.Format_RGB32)
    made.fill(0)
    return made


def drawn(viewport: Viewport) -> int:
    assert viewport.frame_painter is not None
    return viewport.frame_painter.pictures_drawn


def walk_through(window: MainWindow, frames: range = range(1, FRAMES + 1)) -> list[QImage]:
    shown = []
    for frame in frames:
        window.parts.bridge.session.go_to(frame)
        shown.append(window.parts.viewport.grab().toImage())
    return shown


def test_where_no_more_fit_the_frame_goes_that_is_needed_last() -> None:
    document = object()
    frames = FinishedFrames(limit_bytes=3 * image().sizeInBytes())
    for frame in (1, 2, 3, 4, 5):
        frames.keep((document,), frame, image(), 6)
    assert set(frames.frames) == {1, 2, 5}, "of a round of six, 5 was the last one seen and 1 comes soonest"
    assert frames.nbytes == 3 * image().sizeInBytes()
    frames.keep((document,), 5, image(), 6)
    assert frames.nbytes == 3 * image().sizeInBytes(), "one frame is kept once"


def test_a_picture_over_the_limit_is_not_kept() -> None:
    frames = FinishedFrames(limit_bytes=10)
    frames.keep((object(),), 1, image(), 6)
    assert not frames.frames


def test_another_document_or_look_forgets_all() -> None:
    document, frames = object(), FinishedFrames()
    frames.keep((document, "fitted"), 1, image(), 6)
    assert frames.picture((document, "fitted"), 1) is not None
    assert frames.picture((document, "zoomed"), 1) is None
    assert frames.picture((object(), "fitted"), 1) is None
    frames.keep((document, "zoomed"), 2, image(), 6)
    assert set(frames.frames) == {2}


def test_the_second_time_through_nothing_is_drawn_and_all_looks_the_same(walking: MainWindow) -> None:
    first = walk_through(walking)
    before = drawn(walking.parts.viewport)
    assert walk_through(walking) == first
    assert drawn(walking.parts.viewport) == before
    assert set(walking.parts.viewport.finished.frames) == set(range(1, FRAMES + 1))


@pytest.mark.parametrize("what", ["edit", "zoom", "backdrop", "files"])
def test_what_changes_the_picture_is_drawn_anew(walking: MainWindow, what: str) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    walk_through(walking)
    before = drawn(viewport)
    match what:
        case "edit":
            path = resolve(bridge.document, "light.azimuth")
            bridge.session.edit("Turn", set_constant(bridge.document, path, 77.0))
        case "zoom":
            viewport.viewpoint.zoom_middle(1)
        case "backdrop":
            viewport.show_backdrop(Backdrop.BLACK)
        case "files":
            viewport.reread()
    assert not viewport.finished.frames or what in ("zoom", "backdrop")
    walk_through(walking)
    assert drawn(viewport) >= before + FRAMES - 1


def test_what_is_read_off_is_the_frame_that_is_seen(walking: MainWindow) -> None:
    walk_through(walking)
    walking.parts.bridge.session.go_to(2)
    second = picture(walking.parts.viewport)
    walk_through(walking)
    walking.parts.bridge.session.go_to(2)
    assert np.array_equal(picture(walking.parts.viewport), second)


def test_a_frame_with_a_broken_drawing_is_never_kept(walking: MainWindow, qtbot: QtBot) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    source = bridge.document.layers[0].cels.drawings[3].source
    write_garbage(Path(str(source)))
    viewport.reread()
    with qtbot.waitSignal(viewport.broken_changed):
        walk_through(walking)
    assert set(viewport.finished.frames) == set(range(1, FRAMES + 1)) - {4}


def test_while_frames_pass_only_what_shows_the_frame_follows(walking: MainWindow) -> None:
    bridge, settled = walking.parts.bridge, []
    bridge.frame_settled.connect(lambda: settled.append(bridge.frame))
    bridge.session.go_to(2)
    assert settled == [2]
    bridge.let_pass(on=True)
    for frame in (3, 4, 5):
        bridge.session.go_to(frame)
    assert settled == [2]
    bridge.let_pass(on=False)
    assert settled == [2, 5]
    bridge.let_pass(on=False)
    assert settled == [2, 5]
