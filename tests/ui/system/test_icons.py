"""The icons: sharp at every size and scale, each in the tone of what it stands for."""

import gc

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QSize
from PySide6.QtGui import QIcon, QImage

from kagezou.ui.system.icons import icon
from kagezou.ui.system.theme import BRIGHT, OFF, TEXT

pytestmark = pytest.mark.usefixtures("qapp")


def pixels(made: QIcon, side: int, scale: float, mode: QIcon.Mode = QIcon.Mode.Normal) -> NDArray[np.uint8]:
    image = made.pixmap(QSize(side, side), scale, mode).toImage().convertToFormat(QImage.Format.Format_RGBA8888)
    return np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.width(), 4).copy()


@pytest.mark.parametrize("scale", [1.0, 1.25, 1.5, 2.0, 3.0])
def test_a_pixel_of_the_icon_is_one_of_the_screen(scale: float) -> None:
    made = pixels(icon("save"), 18, scale)
    assert made.shape[:2] == (round(18 * scale),) * 2
    direct = pixels(icon("save"), round(18 * scale), 1.0)
    assert np.array_equal(made, direct), "drawn for this scale, not scaled from another"


def test_tones_say_the_state() -> None:
    for mode, tone in ((QIcon.Mode.Normal, TEXT), (QIcon.Mode.Active, BRIGHT), (QIcon.Mode.Disabled, OFF)):
        made = pixels(icon("fit"), 64, 1.0, mode)
        assert (made[made[..., 3] == 255][:, :3] == (tone.red(), tone.green(), tone.blue())).all()


def test_icons_live_as_long_as_they_are_used() -> None:
    kept = QIcon(icon("play"))
    icon.cache_clear()
    gc.collect()
    assert pixels(kept, 20, 1.0)[..., 3].any()
