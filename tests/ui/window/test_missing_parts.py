"""Parts that are not installed: offered in one place, in words for people."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from pytestqt.qtbot import QtBot

from kagezou import extras
from kagezou.extras import DRACO, EXTRAS, PSD, USD, VIDEO
from kagezou.io.images import video
from kagezou.io.sets import gltf_extensions, usd
from kagezou.message import Message
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.missing_parts import MissingParts
from kagezou.ui.window.main_window import MainWindow


@pytest.mark.parametrize("said", [video.MISSING, usd.MISSING, gltf_extensions.DRACO_MISSING], ids=str)
def test_the_terminal_gets_a_command_and_the_window_a_place(said: Message) -> None:
    assert "pip install '" in str(said)
    shown = translated(said)
    assert "pip" not in shown
    assert shown.endswith(": “Missing Parts” in the Help menu shows how")


def test_every_part_says_what_it_is_for() -> None:
    assert len({each.name for each in EXTRAS}) == len(EXTRAS) == 4
    assert str(PSD.how) == "pip install 'aggdraw>=1.4.1,<2' 'scipy>=1.17,<2'"


def test_the_help_menu_lists_what_is_missing(window: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    missing = {USD.module, DRACO.module}
    monkeypatch.setattr(extras, "find_spec", lambda module: None if module in missing else object())
    window.parts.actions["missing_parts"].trigger()
    (dialog,) = window.findChildren(MissingParts)
    assert dialog.words == ["Reading sets in USD files", "Reading sets that are compressed with Draco"]
    assert dialog.command.text().endswith("-m pip install 'usd-core>=26.5' 'DracoPy>=2.2,<3'")
    qtbot.mouseClick(dialog.copy, Qt.MouseButton.LeftButton)
    assert QGuiApplication.clipboard().text() == dialog.command.text()
    dialog.accept()


def test_nothing_missing_is_said(window: MainWindow, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(extras, "find_spec", lambda _module: object())
    assert VIDEO.is_there
    window.parts.actions["missing_parts"].trigger()
    (dialog,) = window.findChildren(MissingParts)
    assert dialog.words == []
    assert not dialog.command.isVisible()
    dialog.accept()
