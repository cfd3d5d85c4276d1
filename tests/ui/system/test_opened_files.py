"""Files that the desktop hands over, and what macOS puts into the program's own menu."""

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QUrl
from PySide6.QtGui import QAction, QFileOpenEvent
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from kagezou.ui.commands.actions import Actions
from kagezou.ui.system.opened_files import OpenedFiles


def test_a_file_that_is_handed_over_is_told(qapp: QApplication, tmp_path: Path) -> None:
    files = OpenedFiles(qapp)
    came: list[Path] = []
    files.came.connect(came.append)
    path = tmp_path / "walk.kage"
    QCoreApplication.sendEvent(qapp, QFileOpenEvent(QUrl.fromLocalFile(str(path))))
    qapp.removeEventFilter(files)
    assert came == [path]


def test_roles_go_by_name_and_not_by_words(qtbot: QtBot) -> None:
    owner = QWidget()
    qtbot.addWidget(owner)
    actions, roles = Actions(owner), QAction.MenuRole
    found = {command.name: actions[command.name].menuRole() for command in actions.commands}
    assert {name: role for name, role in found.items() if role is not roles.NoRole} == {
        "quit": roles.QuitRole,
        "about": roles.AboutRole,
        "preferences": roles.PreferencesRole,
    }
