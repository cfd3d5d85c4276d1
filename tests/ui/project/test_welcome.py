"""The first page: projects of before with their pictures, looks to begin with, and what a drop will do."""

import os
from pathlib import Path

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QDragLeaveEvent, QGuiApplication, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from kagezou.document import properties
from kagezou.document.address import Address, value_of
from kagezou.io.project import file as project_file
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.project.recent_pictures import SIZE, ProjectPictures, kept_at
from kagezou.ui.window.drop_hint import drop_words
from kagezou.ui.window.main_window import MainWindow
from tests.ui import held_files

_MIDDLE = QPointF(300, 300)


def saved(open_project: OpenProject, path: Path) -> Path:
    project_file.save(open_project.bridge.document, path)
    return path


def hold(window: MainWindow, *paths: Path) -> None:
    """Hold files over the window without letting them go."""
    assert held_files.hold(window, held_files.carried(paths), _MIDDLE).isAccepted()


def let_go(window: MainWindow, *paths: Path) -> None:
    held_files.let_go(window, held_files.carried(paths), _MIDDLE)


class TestRecent:
    def test_projects_are_cards_that_open_them(
        self, qtbot: QtBot, filled: OpenProject, window: MainWindow, tmp_path: Path
    ) -> None:
        project = saved(filled, tmp_path / "cut 12.kage")
        window.parts.settings.remember_project(tmp_path / "gone.kage")
        window.parts.settings.remember_project(project)
        filled.clear()
        assert window.pages.currentWidget() is window.parts.welcome
        assert [card.path for card in window.parts.welcome.cards] == [project]
        card = window.parts.welcome.cards[0]
        assert str(project) in card.toolTip()
        qtbot.waitUntil(lambda: not card.picture.is_empty)
        QTest.mouseClick(card, Qt.MouseButton.LeftButton)
        qtbot.waitUntil(lambda: window.parts.open_project.path == project)

    def test_a_picture_is_drawn_once_and_anew_when_the_project_changed(
        self, qtbot: QtBot, filled: OpenProject, tmp_path: Path
    ) -> None:
        if QGuiApplication.platformName() == "offscreen":
            pytest.skip("no display that can show OpenGL; run under Xvfb")
        project = saved(filled, tmp_path / "cut.kage")
        pictures = ProjectPictures(tmp_path / "pictures")
        made: list[QImage] = []
        pictures.made.connect(lambda _path, image: made.append(image))
        pictures.ask([project, tmp_path / "gone.kage"])
        qtbot.waitUntil(lambda: not pictures.is_busy)
        assert [image.size() for image in made] == [SIZE]
        middle = made[0].copy(SIZE.width() // 2 - 40, 20, 80, 100)
        assert len({middle.pixel(x, y) for x in range(0, 80, 4) for y in range(0, 100, 4)}) > 3, "the figure is seen"
        pictures.ask([project])
        assert not pictures.is_busy
        assert len(made) == 2
        os.utime(project, (1, 1))
        assert not kept_at(tmp_path / "pictures", project).exists()

    def test_a_project_that_cannot_be_read_has_no_picture(
        self, qtbot: QtBot, qapp: QApplication, tmp_path: Path
    ) -> None:
        if QGuiApplication.platformName() == "offscreen":
            pytest.skip("no display that can show OpenGL; run under Xvfb")
        (tmp_path / "broken.kage").write_text("{", encoding="utf-8")
        pictures = ProjectPictures(tmp_path / "pictures")
        made: list[QImage] = []
        pictures.made.connect(lambda _path, image: made.append(image))
        pictures.ask([tmp_path / "broken.kage"])
        qtbot.waitUntil(lambda: not pictures.is_busy)
        assert made == []


class TestLooks:
    def test_every_bundled_look_has_its_picture(self, window: MainWindow) -> None:
        for card, file in window.parts.welcome.looks:
            assert (file.path.parent / "pictures" / f"{file.path.stem}.png").is_file()
            assert card.accessibleName() == file.style.name.en
        assert len(window.parts.welcome.looks) == 7

    def test_the_chosen_look_is_put_on_the_first_character_in_the_same_step(
        self, window: MainWindow, cels: Path
    ) -> None:
        water = next(card for card, file in window.parts.welcome.looks if file.style.name.en == "Water")
        other = window.parts.welcome.looks[0][0]
        for card in (other, water):
            card.click()
        assert not other.isChecked()
        window.parts.project.bring([cels])
        layer = window.parts.open_project.bridge.document.layers[0]
        amplitude = Address(properties.OF_LAYER["shadow.wave1.amplitude"], layer.id)
        assert (
            value_of(window.parts.open_project.bridge.document, amplitude, 1)
            != properties.OF_LAYER["shadow.wave1.amplitude"].default
        )
        assert window.parts.welcome.style_chosen is None
        window.parts.actions["undo"].trigger()
        assert window.parts.open_project.is_blank

    def test_its_light_is_left_out_and_that_is_said(self, window: MainWindow, cels: Path) -> None:
        evening = next(card for card, file in window.parts.welcome.looks if file.style.scene)
        evening.click()
        window.parts.project.bring([cels])
        document = window.parts.open_project.bridge.document
        assert "shadow.color" in document.layers[0].tracks
        assert document.brought_light is None
        assert "Long evening came without its own light" in window.parts.bar.text

    def test_a_look_is_let_go_by_a_second_click(self, window: MainWindow) -> None:
        card = window.parts.welcome.looks[1][0]
        card.click()
        card.click()
        assert window.parts.welcome.style_chosen is None

    def test_a_project_that_is_opened_keeps_its_own_look(
        self, filled: OpenProject, window: MainWindow, tmp_path: Path
    ) -> None:
        project = saved(filled, tmp_path / "cut.kage")
        document = filled.bridge.document
        filled.clear()
        window.parts.welcome.looks[4][0].click()
        window.parts.project.open_path(project)
        assert filled.bridge.document == document
        assert filled.is_saved


class TestDrop:
    @pytest.mark.parametrize(
        ("names", "words"),
        [
            (("cut.kage",), "Open cut.kage"),
            (("walker",), "Bring in walker"),
            (("meadow.jpg",), "Put meadow.jpg under everything"),
            (("walker", "walker/walk_0001.png", "x"), "Bring in walker and 2 more"),
        ],
    )
    def test_what_will_happen_is_said(self, english: object, cels: Path, names: tuple[str, ...], words: str) -> None:
        assert drop_words([cels.parent / name for name in names]) == words

    def test_over_the_first_page_and_over_the_picture(self, window: MainWindow, cels: Path) -> None:
        hold(window, cels)
        assert window.parts.welcome._drop_words.text() == "Bring in walker"
        assert not window.drop_hint.isVisible()
        QApplication.sendEvent(window, QDragLeaveEvent())
        assert window.parts.welcome._drop_words.text() == "Drop a folder of cels here"
        window.parts.project.bring([cels])
        hold(window, cels)
        assert window.drop_hint.isVisible()
        assert window.drop_hint.text() == "Bring in walker"
        assert window.drop_hint.width() >= window.pages.width()
        let_go(window, cels)
        assert not window.drop_hint.isVisible()
        assert len(window.parts.open_project.bridge.document.layers) == 2


def test_panels_wait_for_something_to_show(window: MainWindow, cels: Path) -> None:
    assert all(dock.isHidden() for dock in window.docks.all)
    window.parts.project.bring([cels])
    assert not any(dock.isHidden() for dock in window.docks.all)
    window.parts.actions["undo"].trigger()
    assert all(dock.isHidden() for dock in window.docks.all)
