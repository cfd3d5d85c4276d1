"""The status bar: what it says of the frame looked at."""

from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from kagezou.session.session import Session
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.window.status import Status
from tests.scene.jumps import jumping


def test_the_height_is_said_while_the_figure_is_in_the_air(qtbot: QtBot) -> None:
    session = Session(jumping())
    bridge = Bridge(session)
    status = Status(bridge, QLabel())
    qtbot.addWidget(status)

    def said() -> list[str]:
        return [each.text() for each in status.findChildren(QLabel) if "px" in each.text() and not each.isHidden()]

    assert said() == []
    session.go_to(7)
    assert said() == ["Height 120 px"]
    session.go_to(11)
    assert said() == []
