"""The views of the viewport: the picture, the shadow alone, its outline and its matte; and what is laid over them."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.document.edits import set_exposures, set_value
from kagezou.document.model import Exposure
from kagezou.render.prepare.backdrop import Backdrop
from kagezou.ui.viewport.onion_skin import Neighbour, neighbours, tinted
from kagezou.ui.viewport.picture_view import PictureView, behind, line_px
from kagezou.ui.viewport.typed_value import with_typed
from kagezou.ui.window.main_window import MainWindow
from tests.ui.viewing import drag, move, picture


def view(window: MainWindow, name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.int_]]:
    window.parts.actions[f"view_{name}"].trigger()
    return picture(window.parts.viewport)[..., :3].astype(int)


class TestViews:
    def test_the_shadow_alone_is_where_the_composite_has_it_and_the_character_is_gone(
        self, walking: MainWindow
    ) -> None:
        composite, shadow = view(walking, "composite"), view(walking, "shadow")
        dark = (shadow < 255).any(axis=2)
        assert 500 < dark.sum() < dark.size / 2
        same = (composite == shadow).all(axis=2)
        figure = ~same
        assert figure.sum() > 1000
        assert (composite[dark & same] == shadow[dark & same]).all()
        assert (dark & same).sum() > 200

    def test_the_matte_is_the_alpha_of_the_exported_layer(self, walking: MainWindow) -> None:
        shadow, matte = view(walking, "shadow"), view(walking, "matte")
        assert (matte[..., 0] == matte[..., 1]).all()
        assert (matte[..., 0] == matte[..., 2]).all()
        assert matte.max() == pytest.approx(0.6 * 255, abs=1)
        assert ((matte[..., 0] > 0) == (shadow < 255).any(axis=2)).mean() > 0.999

    def test_the_outline_runs_where_half_is_covered(self, walking: MainWindow) -> None:
        matte, outline = view(walking, "matte")[..., 0], view(walking, "outline")
        drawn = np.abs(outline - (213, 94, 0)).sum(axis=2) < 60
        assert drawn.sum() > 100
        inside = matte > 0.3 * 255
        edge = np.zeros_like(inside)
        edge[1:-1, 1:-1] = (inside[1:-1, 1:-1] != inside[:-2, 1:-1]) | (inside[1:-1, 1:-1] != inside[1:-1, :-2])
        ys, xs = np.nonzero(drawn)
        near = [edge[max(y - 2, 0) : y + 3, max(x - 2, 0) : x + 3].any() for y, x in zip(ys, xs, strict=True)]
        assert np.mean(near) > 0.99

    def test_one_view_at_a_time_and_back(self, walking: MainWindow) -> None:
        before = view(walking, "composite")
        for name in ("shadow", "outline", "matte"):
            assert (view(walking, name) != before).any()
            checked = [each for each in PictureView if walking.parts.actions[f"view_{each.value}"].isChecked()]
            assert checked == [PictureView(name)]
        assert (view(walking, "composite") == before).all()

    def test_an_unreadable_drawing_is_left_out_of_every_view(self, qtbot: QtBot, walking: MainWindow) -> None:
        path = walking.parts.open_project.bridge.document.layers[0].cels.drawings[1].path
        path.write_bytes(b"no picture")
        walking.parts.open_project.bridge.session.go_to(2)
        for each in PictureView:
            assert view(walking, each.value).std() < 1
        qtbot.waitUntil(lambda: path.name in walking.parts.bar.text)

    def test_a_view_follows_edits(self, walking: MainWindow) -> None:
        before = view(walking, "matte").max()
        layer = walking.parts.open_project.bridge.document.layers[0]
        opacity = Address(properties.OF_LAYER["shadow.opacity"], layer.id)
        walking.parts.open_project.bridge.session.edit(
            "Opacity", set_value(walking.parts.open_project.bridge.document, opacity, 1.0, 1)
        )
        assert picture(walking.parts.viewport)[..., 0].max() == 255 > before

    def test_what_is_behind(self) -> None:
        assert behind(PictureView.MATTE, Backdrop.CHECKER, has_background=True) is Backdrop.BLACK
        assert behind(PictureView.SHADOW, Backdrop.BACKGROUND, has_background=True) is Backdrop.WHITE
        assert behind(PictureView.SHADOW, Backdrop.CHECKER, has_background=True) is Backdrop.CHECKER
        assert behind(PictureView.COMPOSITE, Backdrop.BACKGROUND, has_background=True) is Backdrop.BACKGROUND
        assert [line_px(PictureView.OUTLINE, zoom) for zoom in (4.0, 1.0, 0.25)] == [1, 1, 4]
        assert line_px(PictureView.MATTE, 0.1) == 0


class TestSheets:
    def test_guides_lie_where_they_should(self, walking: MainWindow) -> None:
        actions, guides = walking.parts.actions, walking.parts.sheets.guides
        assert not guides.isVisible()
        actions["safe_area"].trigger()
        assert guides.isVisible()
        assert guides.size() == walking.parts.viewport.size()
        drawn, canvas = guides.grab().toImage(), guides.canvas
        x, y = round(canvas.left() + 0.05 * canvas.width()), round(canvas.center().y() + 30)
        around = [QColor(drawn.pixelColor(x + step, y)).alpha() for step in range(-3, 4)]
        assert max(around) > 60, "the action safe line, 5 % from the edge"
        fields_before = sum(drawn.pixelColor(column, y).alpha() > 60 for column in range(drawn.width()))
        actions["field_guide"].trigger()
        drawn = guides.grab().toImage()
        assert sum(drawn.pixelColor(column, y).alpha() > 60 for column in range(drawn.width())) > fields_before + 10
        for name in ("safe_area", "field_guide"):
            actions[name].trigger()
        assert not guides.isVisible()

    def test_a_snapshot_is_taken_shown_and_wiped(self, walking: MainWindow) -> None:
        actions, snapshot = walking.parts.actions, walking.parts.sheets.snapshot
        assert not actions["snapshot_show"].isEnabled()
        taken = picture(walking.parts.viewport)
        actions["snapshot_take"].trigger()
        view(walking, "matte")
        actions["snapshot_show"].trigger()
        assert snapshot.isVisible()
        middle = snapshot.canvas.center().toPoint()
        shown = snapshot.grab().toImage()
        height, width = taken.shape[:2]
        color = shown.pixelColor(middle)
        seen = (color.red(), color.green(), color.blue())
        assert np.abs(np.array(seen) - taken[height // 2, width // 2, :3]).max() <= 2
        actions["snapshot_wipe"].trigger()
        move(walking.parts.viewport, QPoint(middle.x() - 20, middle.y()))
        assert snapshot.grab().toImage().pixelColor(middle).alpha() == 0
        move(walking.parts.viewport, QPoint(middle.x() + 20, middle.y()))
        assert snapshot.grab().toImage().pixelColor(middle).alpha() == 255
        actions["snapshot_show"].trigger()
        assert not snapshot.isVisible()


class TestOnionSkin:
    def test_neighbours_are_drawings_not_frames(self, walking: MainWindow) -> None:
        document = walking.parts.open_project.bridge.document
        held = (Exposure(1, 0), Exposure(3, 1), Exposure(4, None), Exposure(5, 2), Exposure(6, 3))
        layer = set_exposures(document, document.layers[0].id, held).layers[0]
        assert neighbours(layer, 3, 1) == (Neighbour(1, -1), Neighbour(5, 1))
        assert neighbours(layer, 4, 2) == (Neighbour(1, -2), Neighbour(6, 2), Neighbour(3, -1), Neighbour(5, 1))
        assert neighbours(layer, 2, 3) == (Neighbour(6, 3), Neighbour(5, 2), Neighbour(3, 1))

    def test_tints_tell_before_from_after_and_the_present_covers_them(self) -> None:
        grey = np.full((1, 2, 4), (90, 90, 90, 255), np.uint8)
        present = np.array([[0.0, 1.0]])
        before, after = tinted(grey, -1, present), tinted(grey, 2, present)
        assert before[0, 0, 0] > before[0, 0, 2]
        assert after[0, 0, 2] > after[0, 0, 0]
        assert before[0, 0, 3] == 2 * after[0, 0, 3]
        assert before[0, 1, 3] == 0

    def test_they_are_drawn_at_rest_and_gone_with_the_frame(self, qtbot: QtBot, walking: MainWindow) -> None:
        session, onion_skin = walking.parts.open_project.bridge.session, walking.parts.sheets.onion_skin
        session.go_to(3)
        before = picture(walking.parts.viewport)
        walking.parts.actions["onion_skin"].trigger()
        assert onion_skin.images == []
        qtbot.waitUntil(lambda: len(onion_skin.images) == 2)
        assert onion_skin.isVisible()
        assert (picture(walking.parts.viewport) == before).all(), "the frame itself is what it was"
        drawn = onion_skin.grab().toImage()
        seen = {
            drawn.pixelColor(x, y).alpha() > 0 for x in range(0, drawn.width(), 4) for y in range(0, drawn.height(), 4)
        }
        assert seen == {True, False}
        session.go_to(4)
        assert onion_skin.images == []
        assert not onion_skin.isVisible()
        walking.parts.actions["onion_skin"].trigger()
        # Nothing is drawn but when the hand has rested, and that is not waited for any more.
        assert not onion_skin._rest.isActive()
        onion_skin._go_on()
        assert onion_skin.images == []

    def test_nothing_is_drawn_while_the_cut_plays(self, qtbot: QtBot, walking: MainWindow) -> None:
        walking.parts.actions["onion_skin"].trigger()
        onion_skin = walking.parts.sheets.onion_skin
        walking.parts.time.player.toggle()
        shown: list[int] = []
        walking.parts.bridge.frame_changed.connect(shown.append)
        qtbot.waitUntil(lambda: len(shown) > 3)
        # Each frame takes the neighbours of the one before away; asked for meanwhile, they wait for rest again.
        onion_skin._go_on()
        assert onion_skin.images == []
        assert onion_skin._rest.isActive()
        walking.parts.time.player.stop()
        qtbot.waitUntil(lambda: bool(walking.parts.sheets.onion_skin.images))

    def test_how_many_is_chosen_and_remembered(self, qtbot: QtBot, walking: MainWindow) -> None:
        walking.parts.open_project.bridge.session.go_to(3)
        walking.parts.menus.onion.actions()[1].trigger()
        assert walking.parts.actions["onion_skin"].isChecked()
        assert walking.parts.settings.word("onion_drawings", "") == "2"
        qtbot.waitUntil(lambda: len(walking.parts.sheets.onion_skin.images) == 4)


class TestTyping:
    def test_what_is_typed_while_dragging_is_the_value(self, qtbot: QtBot, walking: MainWindow) -> None:
        viewport, session = walking.parts.viewport, walking.parts.open_project.bridge.session
        viewport.setFocus()
        declination = Address(properties.GROUND_DECLINATION)
        drag(qtbot, viewport, "ground.declination", QPoint(0, 25), let_go=False)
        QTest.keyClicks(viewport, "4.5")
        QTest.keyClick(viewport, Qt.Key.Key_Backspace)
        QTest.keyClick(viewport, Qt.Key.Key_Backspace)
        QTest.keyClicks(viewport, "2.")
        QTest.keyClicks(viewport, "5")
        assert "42.5" in viewport.controller.words
        move(viewport, QPoint(20, 20))
        assert value_of(session.document, declination, 1) == 42.5
        assert walking.parts.open_project.bridge.frame == 1, "the full stop is no command while a handle is held"
        QTest.keyClick(viewport, Qt.Key.Key_Return)
        assert not viewport.controller.is_busy
        assert value_of(session.document, declination, 1) == 42.5
        session.undo()
        assert value_of(session.document, declination, 1) != 42.5

    def test_escape_takes_the_typed_value_back(self, qtbot: QtBot, walking: MainWindow) -> None:
        viewport, session = walking.parts.viewport, walking.parts.open_project.bridge.session
        before = session.document
        drag(qtbot, viewport, "ground.position", QPoint(10, 10), let_go=False)
        QTest.keyClicks(viewport, "50")
        assert session.document is not before
        QTest.keyClick(viewport, Qt.Key.Key_Escape)
        assert session.document is before

    @pytest.mark.parametrize(
        ("text", "place"),
        [("50", (50.0, None)), ("50,60", (50.0, 60.0)), (",60", (None, 60.0)), ("+10,*2", (10, 2)), ("1,2,3", None)],
    )
    def test_places_are_typed_by_their_coordinates(
        self, walking: MainWindow, text: str, place: tuple[float | None, float | None] | None
    ) -> None:
        document = walking.parts.open_project.bridge.document
        handle = walking.parts.viewport.controller.handles.find("ground.position")
        assert handle is not None
        position = Address(properties.GROUND_POSITION)
        x, y = np.asarray(value_of(document, position, 1), float)
        made = with_typed(handle, document, 1, text)
        if place is None:
            assert made is None
            return
        assert made is not None
        wanted = (x + 10, y * 2) if "*" in text else (place[0] or x, place[1] or y)
        assert value_of(made, position, 1) == pytest.approx(wanted)

    @pytest.mark.parametrize("text", ["", "-", "4+", "x", "1,2,3,4,5"])
    def test_half_a_number_changes_nothing(self, walking: MainWindow, text: str) -> None:
        handle = walking.parts.viewport.controller.handles.find("ground.declination")
        assert handle is not None
        assert with_typed(handle, walking.parts.open_project.bridge.document, 1, text) is None
