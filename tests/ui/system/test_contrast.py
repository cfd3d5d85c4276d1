"""What is seen at a glance: the contrast of controls and texts, measured from the pixels that they are drawn with.

Controls need 3 to 1 against what they stand on while nobody touches them, texts 4.5 to 1 (WCAG 2.2, 1.4.3 and 1.4.11);
what cannot be used now is exempt. Focus must change pixels by 3 to 1.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import pytest
from numpy.typing import NDArray
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QRadioButton,
    QTabBar,
    QToolButton,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from kagezou.ui.system.icons import icon
from kagezou.ui.system.theme import BRIGHT, CHANGED, CHOSEN, CHROME, DIM, ERROR, RAISED, SELECTED, TEXT, WARNING, WELL
from kagezou.ui.widgets.color_button import Swatch
from kagezou.ui.widgets.key_button import KeyButton, KeyState
from kagezou.ui.widgets.link_button import LinkButton
from kagezou.ui.widgets.range_slider import RangeSlider
from kagezou.ui.widgets.scrub_field import ScrubField

Make = Callable[[], QWidget]


def luminance(rgb: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the relative luminance of colours (..., 3), 0 to 1 in sRGB."""
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return np.asarray(linear @ np.array([0.2126, 0.7152, 0.0722]))


def contrast(one: NDArray[np.float64], other: NDArray[np.float64]) -> NDArray[np.float64]:
    a, b = luminance(one), luminance(other)
    return np.asarray((np.maximum(a, b) + 0.05) / (np.minimum(a, b) + 0.05))


def rgb(color: QColor) -> NDArray[np.float64]:
    return np.array([color.redF(), color.greenF(), color.blueF()])


def pixels(widget: QWidget) -> NDArray[np.float64]:
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3) / 255


def on_a_page(qtbot: QtBot, make: Make) -> tuple[QWidget, QWidget]:
    """Return a page of the usual ground with a control in its middle, and the control."""
    page = QWidget()
    qtbot.addWidget(page)
    column = QVBoxLayout(page)
    column.setContentsMargins(24, 24, 24, 24)
    control = make()
    column.addWidget(control)
    page.resize(260, 120)
    page.show()
    qtbot.waitExposed(page)
    control.clearFocus()
    QApplication.processEvents()
    return page, control


def strongest(page: QWidget, control: QWidget) -> float:
    """Return the highest contrast between a pixel of a control and the ground it stands on."""
    whole = pixels(page)
    ground, corner = whole[4, 4], control.mapTo(page, QPoint(0, 0))
    own = whole[corner.y() : corner.y() + control.height(), corner.x() : corner.x() + control.width()]
    return float(contrast(own, ground).max())


def checked(make: Callable[[], QCheckBox | QRadioButton | QToolButton]) -> QWidget:
    made = make()
    made.setCheckable(True)
    made.setChecked(True)
    return made


def tool(text: str, name: str = "") -> QToolButton:
    button = QToolButton()
    button.setText(text)
    if name:
        button.setIcon(icon(name))
    return button


def key(state: KeyState) -> KeyButton:
    made = KeyButton()
    made.show_state(state)
    return made


def link(*, linked: bool) -> LinkButton:
    made = LinkButton()
    made.show_linked(linked=linked)
    return made


def combo() -> QComboBox:
    made = QComboBox()
    made.addItem("")
    return made


def tabs() -> QTabBar:
    made = QTabBar()
    made.addTab("Keys")
    made.addTab("Notes")
    return made


CONTROLS: dict[str, Make] = {
    "check box, off": QCheckBox,
    "check box, on": partial(checked, QCheckBox),
    "radio button, off": QRadioButton,
    "radio button, on": partial(checked, QRadioButton),
    "push button without words": QPushButton,
    "tool button, picture": lambda: tool("", "eye"),
    "tool button, shut eye": lambda: tool("", "eye-off"),
    "tool button, words": lambda: tool("Fit"),
    "tool button, on": lambda: checked(lambda: tool("", "loop")),
    "combo box, empty": combo,
    "line, empty": QLineEdit,
    "text, empty": QPlainTextEdit,
    "number": ScrubField,
    "spin box": QDoubleSpinBox,
    "slider": lambda: RangeSlider(0.0, 1.0),
    "key, none": lambda: key(KeyState.NONE),
    "key, elsewhere": lambda: key(KeyState.KEYED),
    "key, here": lambda: key(KeyState.HERE),
    "link, apart": lambda: link(linked=False),
    "link, linked": lambda: link(linked=True),
    "swatch of black": Swatch,
    "tabs": tabs,
}
"""Every kind of control in the states in which nobody touches it."""

FOCUSED = [name for name in CONTROLS if name != "swatch of black"]


@pytest.mark.parametrize("name", CONTROLS)
def test_controls_that_nobody_touches_are_seen(qtbot: QtBot, name: str) -> None:
    assert strongest(*on_a_page(qtbot, CONTROLS[name])) >= 3.0


@pytest.mark.parametrize("name", ["check box, off", "radio button, off"])
def test_on_and_off_are_told_apart(qtbot: QtBot, name: str) -> None:
    off = pixels(on_a_page(qtbot, CONTROLS[name])[0])
    on = pixels(on_a_page(qtbot, CONTROLS[name.replace("off", "on")])[0])
    assert contrast(off, on).max() >= 3.0


@pytest.mark.parametrize("name", CONTROLS)
def test_the_focus_is_seen(qtbot: QtBot, focus: Callable[[QWidget], None], name: str) -> None:
    page, control = on_a_page(qtbot, CONTROLS[name])
    if name.startswith("text"):
        control.setCursorWidth(0)  # type: ignore[attr-defined]
    before = pixels(page)
    focus(control)
    QApplication.processEvents()
    changed = contrast(before, pixels(page))
    assert changed.max() >= 3.0 or (changed >= 2.0).sum() >= 8


@pytest.mark.parametrize("tone", [TEXT, BRIGHT, DIM, SELECTED, CHANGED, WARNING], ids=lambda tone: tone.name())
@pytest.mark.parametrize("ground", [CHROME, WELL, QColor("#232323"), QColor("#2f2f2f")], ids=lambda tone: tone.name())
def test_texts_are_read(qtbot: QtBot, tone: QColor, ground: QColor) -> None:
    label = QLabel("HIMLE 0123")
    label.setStyleSheet(f"color: {tone.name()}; background: {ground.name()}")
    qtbot.addWidget(label)
    label.show()
    drawn = pixels(label)
    assert contrast(drawn, rgb(ground)).max() >= 4.5


@pytest.mark.parametrize(
    ("tone", "ground"), [(TEXT, CHOSEN), (BRIGHT, CHOSEN), (TEXT, RAISED), (ERROR, WELL)], ids=lambda tone: tone.name()
)
def test_texts_on_chosen_and_raised_grounds_are_read(tone: QColor, ground: QColor) -> None:
    least = 3.0 if tone is ERROR else 4.5
    assert contrast(rgb(tone), rgb(ground)) >= least
