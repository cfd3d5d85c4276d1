"""F1 opens the manual where it explains what the pointer is over; links and search lead on."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QShortcut
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QWidget
from pytestqt.qtbot import QtBot

from kagezou.ui.help.manual import Manual
from kagezou.ui.project.cut_settings_dialog import CutSettingsDialog
from kagezou.ui.system.language import Language
from kagezou.ui.window.main_window import MainWindow
from kagezou.ui.window.wiring.help import sections
from tests.ui.viewing import move, place_of


def activate(qtbot: QtBot, dialog: QWidget, present: Callable[[], None]) -> None:
    """Give a dialog the keyboard, as a window manager does."""

    def is_active() -> bool:
        present()
        dialog.activateWindow()
        QApplication.processEvents()
        return dialog.isActiveWindow()

    qtbot.waitUntil(is_active)


def opened(window: MainWindow) -> Manual:
    assert window.help.manual is not None
    return window.help.manual


@pytest.mark.parametrize("language", ["en", "ja"])
def test_every_row_of_the_inspector_is_explained(walking: MainWindow, english: Language, language: str) -> None:
    english.speak(language)
    inspector = walking.parts.panels.inspector
    for row in [inspector.row(each.address.property.name) for each in inspector.edited]:
        page, term = walking.help.place_of(row.label)
        assert walking.help.place_of(row.key) == (page, term)
        walking.help.open_at((page, term))
        manual = opened(walking)
        assert manual.pages.page == page
        assert manual.pages.marked.startswith(term), row.address.property.name


def test_every_panel_has_its_page(walking: MainWindow) -> None:
    parts = walking.parts
    pages: list[tuple[QWidget, str]] = [
        (parts.panels.layers.view, "layers"),
        (parts.sets.pieces, "sets"),
        (parts.panels.styles.list, "styles"),
        (parts.time.timeline.lanes, "timeline"),
        (parts.curves.made().graph, "curves"),
        (parts.time.transport, "timeline"),
        (parts.viewport, "words"),
        (parts.welcome, "first-cut"),
        (walking.statusBar(), "index"),
    ]
    assert [walking.help.place_of(widget) for widget, _ in pages] == [(page, "") for _, page in pages]


def test_a_handle_is_explained_as_its_property(walking: MainWindow) -> None:
    viewport = walking.parts.viewport
    move(viewport, place_of(viewport, "light.lamp"))
    assert walking.help.place_of(viewport.overlay) == ("light", "Light position")


def test_the_key_opens_it_beside_the_picture(qtbot: QtBot, active: MainWindow, present: Callable[[], None]) -> None:
    def is_open() -> bool:
        activate(qtbot, active, present)
        QTest.keyClick(active, Qt.Key.Key_F1)
        return active.help.manual is not None

    qtbot.waitUntil(is_open)
    manual = opened(active)
    qtbot.waitExposed(manual)
    assert manual.isWindow()
    assert manual.windowModality() is Qt.WindowModality.NonModal


def test_within_a_dialog_the_key_opens_it_too_and_it_can_be_used(
    qtbot: QtBot, active: MainWindow, present: Callable[[], None]
) -> None:
    active.parts.actions["cut_settings"].trigger()
    (dialog,) = active.findChildren(CutSettingsDialog)
    activate(qtbot, dialog, present)
    qtbot.waitUntil(lambda: bool(dialog.findChildren(QShortcut)))
    assert active.help.place_of(dialog) == ("saving", "")

    def is_open() -> bool:
        # Where other windows come and go, the keyboard may go elsewhere between two lines.
        activate(qtbot, dialog, present)
        QTest.keyClick(dialog, Qt.Key.Key_F1)
        return active.help.manual is not None

    qtbot.waitUntil(is_open)
    manual = opened(active)
    assert manual.parentWidget() is dialog, "or the dialog would keep the keyboard from it"
    dialog.close()
    dialog.deleteLater()
    qtbot.waitUntil(lambda: active.help.manual is None)
    active.help.open_at(("light", ""))
    assert opened(active).parentWidget() is active


def test_dialogs_listen_once(qtbot: QtBot, active: MainWindow, present: Callable[[], None]) -> None:
    dialog = QDialog(active)
    dialog.show()
    activate(qtbot, dialog, present)
    active.help.follow_window()
    active.help.follow_window()
    assert len(dialog.findChildren(QShortcut)) == len(active.parts.actions["manual"].shortcuts())


@pytest.fixture
def manual(qtbot: QtBot) -> Manual:
    made = Manual(sections())
    qtbot.addWidget(made)
    made.open()
    return made


def test_links_lead_to_pages_and_back(manual: Manual) -> None:
    assert manual.pages.page == "index"
    manual.pages.setSource(QUrl("light.md"))
    assert manual.pages.page == "light"
    assert "light.overhead_radius" in manual.pages.toPlainText(), "its properties are written out"
    assert manual.contents.currentItem().text() == "Light"
    manual.pages.backward()
    assert manual.pages.page == "index"


def test_the_list_opens_pages(qtbot: QtBot, manual: Manual) -> None:
    (item,) = manual.contents.findItems("Light", Qt.MatchFlag.MatchExactly)
    manual.contents.scrollToItem(item)
    at = manual.contents.visualItemRect(item).center()
    qtbot.mouseClick(manual.contents.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert manual.pages.page == "light"


def test_search_leaves_the_pages_with_all_words(qtbot: QtBot, manual: Manual) -> None:
    qtbot.keyClicks(manual.search, "grounding POINT walk")
    shown = [
        manual.contents.item(row).text()
        for row in range(manual.contents.count())
        if not manual.contents.item(row).isHidden()
    ]
    assert "Where the figure stands" in shown
    assert "Styles" not in shown


def test_an_unknown_page_is_the_contents(manual: Manual) -> None:
    manual.open("no-such-page", "nothing")
    assert manual.pages.page == "index"
    assert manual.pages.marked == ""


def test_a_page_begins_at_its_top(manual: Manual) -> None:
    manual.resize(700, 300)
    manual.open("shape", "Tip distance")
    assert manual.pages.verticalScrollBar().value() > 0
    manual.open("shape")
    assert manual.pages.verticalScrollBar().value() == 0
    assert manual.pages.marked == ""
