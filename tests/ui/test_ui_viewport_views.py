"""The views of the viewport: the picture, the shadow alone, its outline and its matte; and what is laid over them."""

import numpy as np
import pytest
from pytestqt.qtbot import QtBot
from viewing import picture

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.edits import set_value
from kagezou.render.backdrop import Backdrop
from kagezou.ui.main_window import MainWindow
from kagezou.ui.viewport.picture_view import PictureView, behind, line_px


def view(window: MainWindow, name: str) -> np.ndarray[tuple[int, ...], np.dtype[np.int_]]:
    window.actions_of[f"view_{name}"].trigger()
    return picture(window.viewport)[..., :3].astype(int)


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
            checked = [each for each in PictureView if walking.actions_of[f"view_{each.value}"].isChecked()]
            assert checked == [PictureView(name)]
        assert (view(walking, "composite") == before).all()

    def test_an_unreadable_drawing_is_left_out_of_every_view(self, qtbot: QtBot, walking: MainWindow) -> None:
        path = walking.desk.bridge.document.layers[0].cels.drawings[1].path
        path.write_bytes(b"no picture")
        walking.desk.bridge.session.go_to(2)
        for each in PictureView:
            assert view(walking, each.value).std() < 1
        qtbot.waitUntil(lambda: path.name in walking.bar.text)

    def test_a_view_follows_edits(self, walking: MainWindow) -> None:
        before = view(walking, "matte").max()
        layer = walking.desk.bridge.document.layers[0]
        opacity = Address(properties.OF_LAYER["shadow.opacity"], layer.id)
        walking.desk.bridge.session.edit("Opacity", set_value(walking.desk.bridge.document, opacity, 1.0, 1))
        assert picture(walking.viewport)[..., 0].max() == 255 > before

    def test_what_is_behind(self) -> None:
        assert behind(PictureView.MATTE, Backdrop.CHECKER, has_background=True) is Backdrop.BLACK
        assert behind(PictureView.SHADOW, Backdrop.BACKGROUND, has_background=True) is Backdrop.WHITE
        assert behind(PictureView.SHADOW, Backdrop.CHECKER, has_background=True) is Backdrop.CHECKER
        assert behind(PictureView.COMPOSITE, Backdrop.BACKGROUND, has_background=True) is Backdrop.BACKGROUND
        assert [line_px(PictureView.OUTLINE, zoom) for zoom in (4.0, 1.0, 0.25)] == [1, 1, 4]
        assert line_px(PictureView.MATTE, 0.1) == 0
