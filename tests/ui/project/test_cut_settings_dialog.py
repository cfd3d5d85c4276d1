"""The settings of the cut in the window: one dialog, one step, and the places from which it opens."""

from dataclasses import replace
from fractions import Fraction

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from kagezou.document.address import Address, value_of
from kagezou.document.cut_settings import ChangedCut
from kagezou.document.edits import set_canvas, set_key
from kagezou.document.figure_properties import SCALE
from kagezou.document.properties import GROUND_POSITION, OPACITY
from kagezou.document.refitting import Refit
from kagezou.document.slate import Slate
from kagezou.document.values import value_at
from kagezou.ui.curves.frame_axis import FrameAxis
from kagezou.ui.export.dialog import ExportDialog
from kagezou.ui.project.canvas_sizes import usual_sizes
from kagezou.ui.project.cut_names import output_name
from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.time.transport import FrameField
from kagezou.ui.window.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def dialog(qtbot: QtBot, filled: OpenProject) -> CutSettingsDialog:
    made = CutSettingsDialog(filled.bridge.document)
    qtbot.addWidget(made)
    made.show()
    return made


def agreed(qtbot: QtBot, dialog: CutSettingsDialog) -> ChangedCut:
    with qtbot.waitSignal(dialog.chosen) as said:
        qtbot.mouseClick(dialog.agree, LEFT)
    changed = said.args[0] if said.args else None
    assert isinstance(changed, ChangedCut)
    return changed


def typed(qtbot: QtBot, field: QWidget, text: str) -> None:
    field.setFocus()
    select = getattr(field, "selectAll", None)
    assert callable(select)
    select()
    qtbot.keyClicks(field, text)


def test_nothing_chosen_changes_nothing(qtbot: QtBot, dialog: CutSettingsDialog, filled: OpenProject) -> None:
    assert "Nothing." in dialog.says.text()
    assert not any(button.isEnabled() for button in dialog.refits.buttons())
    assert agreed(qtbot, dialog).document is filled.bridge.document


def test_a_usual_size_is_picked_and_what_it_does_is_said(
    qtbot: QtBot, dialog: CutSettingsDialog, filled: OpenProject
) -> None:
    row = dialog.size_row
    assert (row.width_box.value(), row.height_box.value()) == (240, 200)
    at = [row.usual.itemText(index).split("   ")[0] for index in range(row.usual.count())].index("HD")
    row.usual.setFocus()
    row.usual.setCurrentIndex(at)
    row.usual.activated.emit(at)
    assert row.size_px == (1280, 720)
    qtbot.mouseClick(dialog.refits.button(list(Refit).index(Refit.SCALE)), LEFT)
    assert "360 %" in dialog.says.text()
    assert "the middle 864 × 720 px" in dialog.says.text()
    changed = agreed(qtbot, dialog).document
    layer = filled.bridge.document.layers[0].id
    assert value_of(changed, Address(SCALE, layer), 1) == pytest.approx((360.0, 360.0))


def test_a_size_that_is_typed_shows_whether_it_is_a_usual_one(qtbot: QtBot, dialog: CutSettingsDialog) -> None:
    typed(qtbot, dialog.size_row.width_box, "1920")
    assert dialog.size_row.usual.currentText() == "Own size"
    typed(qtbot, dialog.size_row.height_box, "1080")
    assert dialog.size_row.usual.currentText().startswith("Full HD")
    assert agreed(qtbot, dialog).document.canvas.width_px == 1920


@pytest.mark.parametrize(
    ("text", "rate"),
    [("23.976", Fraction(24000, 1001)), ("12.5", Fraction(25, 2)), ("30000/1001", Fraction(30000, 1001))],
)
def test_any_rate_is_typed(qtbot: QtBot, dialog: CutSettingsDialog, text: str, rate: Fraction) -> None:
    field = dialog.rate.lineEdit()
    assert field is not None
    typed(qtbot, field, text)
    assert "frames a second the cut lasts" in dialog.says.text()
    assert agreed(qtbot, dialog).document.canvas.frame_rate == rate


def test_what_is_no_rate_is_said_and_cannot_be_agreed_to(qtbot: QtBot, dialog: CutSettingsDialog) -> None:
    field = dialog.rate.lineEdit()
    assert field is not None
    typed(qtbot, field, "fast")
    assert "is not a number of frames a second" in dialog.says.text()
    assert not dialog.agree.isEnabled()
    typed(qtbot, field, "25")
    assert dialog.agree.isEnabled()


def test_an_odd_rate_stays_exact(qtbot: QtBot, filled: OpenProject) -> None:
    canvas = replace(filled.bridge.document.canvas, frame_rate=Fraction(1000, 37))
    dialog = CutSettingsDialog(set_canvas(filled.bridge.document, canvas))
    qtbot.addWidget(dialog)
    assert dialog.settings().canvas.frame_rate == Fraction(1000, 37)


def test_a_length_is_typed_as_frames_or_as_seconds(qtbot: QtBot, dialog: CutSettingsDialog) -> None:
    typed(qtbot, dialog.length, "36")
    assert dialog.seconds.text() == "1+12"
    typed(qtbot, dialog.seconds, "2+06")
    assert dialog.length.value() == 54
    typed(qtbot, dialog.seconds, "long")
    assert "is not a frame" in dialog.says.text()
    assert not dialog.agree.isEnabled()
    typed(qtbot, dialog.seconds, "2:06")
    assert agreed(qtbot, dialog).document.canvas.length_frames == 54


def test_what_lies_behind_a_new_end_is_said_before(qtbot: QtBot, filled: OpenProject) -> None:
    document = filled.bridge.document
    for frame in (2, 5):
        document = set_key(document, Address(OPACITY, document.layers[0].id), frame, 0.5)
    dialog = CutSettingsDialog(document)
    qtbot.addWidget(dialog)
    dialog.show()
    typed(qtbot, dialog.length, "3")
    assert "Keys behind the new end, kept and not reached: 1" in dialog.says.text()
    assert "not seen: 3" in dialog.says.text()


def test_numbers_and_names_go_into_the_document(qtbot: QtBot, dialog: CutSettingsDialog) -> None:
    for field, text in ((dialog.name, "ep3"), (dialog.scene, "2"), (dialog.cut, "12A"), (dialog.first, "101")):
        typed(qtbot, field, text)
    assert dialog.last.text() == "to 106"
    changed = agreed(qtbot, dialog).document
    assert changed.slate == Slate("ep3", "2", "12A")
    assert changed.canvas.first_frame == 101


def test_every_usual_size_is_one_that_a_cut_can_have() -> None:
    sizes = usual_sizes()
    assert len(set(sizes.values())) == len(sizes)
    assert all(1 <= side <= 16384 for size in sizes.values() for side in size)


def test_frames_are_typed_and_shown_by_their_numbers(qtbot: QtBot, filled: OpenProject) -> None:
    bridge = filled.bridge
    field = FrameField(bridge)
    qtbot.addWidget(field)
    bridge.session.edit("numbers", set_canvas(bridge.document, replace(bridge.document.canvas, first_frame=101)))
    assert field.text() == "101"
    typed(qtbot, field, "104")
    qtbot.keyClick(field, Qt.Key.Key_Return)
    assert bridge.frame == 4
    assert field.text() == "104"
    assert FrameAxis(bridge).tickStrings([4.0, 0.0], 1, 1) == ["104  (0+04)", ""]


def test_the_slate_names_what_is_made_of_the_cut(walking: MainWindow) -> None:
    bridge = walking.parts.bridge
    assert output_name(bridge.document, "walk") == "walk"
    bridge.session.edit("slate", replace(bridge.document, slate=Slate("ep 3/4", "2", "12A")))
    walking.parts.actions["export"].trigger()
    (dialog,) = walking.findChildren(ExportDialog)
    assert dialog.folder.text().endswith("ep 3_4_s2_c12A_export")
    dialog.reject()


def opened(qtbot: QtBot, window: MainWindow) -> CutSettingsDialog:
    def dialogs() -> list[CutSettingsDialog]:
        return [each for each in window.findChildren(CutSettingsDialog) if each.isVisible()]

    qtbot.waitUntil(lambda: bool(dialogs()))
    return dialogs()[0]


def test_a_click_on_size_or_rate_opens_it_and_the_change_is_one_step(qtbot: QtBot, walking: MainWindow) -> None:
    bridge, before = walking.parts.bridge, walking.parts.bridge.document
    qtbot.mouseClick(walking.parts.status.canvas, LEFT)
    dialog = opened(qtbot, walking)
    dialog.size_row.show_size(480, 400)
    typed(qtbot, dialog.first, "0")
    qtbot.mouseClick(dialog.agree, LEFT)
    qtbot.waitUntil(lambda: bridge.document.canvas.width_px == 480)
    assert walking.parts.status.canvas.text() == "480 × 400"
    x, y = value_at(before.tracks, GROUND_POSITION, 1)
    assert value_at(bridge.document.tracks, GROUND_POSITION, 1) == (x + 120, y + 100)
    assert walking.parts.time.transport.frame_field.text() == "0"
    assert bridge.session.undo_name == "Change cut settings"
    bridge.session.undo()
    assert bridge.document is before
    QApplication.processEvents()
    qtbot.mouseClick(walking.parts.time.transport.rate, LEFT)
    dialog = opened(qtbot, walking)
    field = dialog.rate.lineEdit()
    assert field is not None
    typed(qtbot, field, "12")
    qtbot.mouseClick(dialog.agree, LEFT)
    qtbot.waitUntil(lambda: walking.parts.time.transport.rate.text() == "12 fps")
