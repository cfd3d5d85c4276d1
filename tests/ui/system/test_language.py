"""The language of the window: the system's where it is spoken, and no translator that stays behind."""

import re
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QCoreApplication, QObject, QTranslator
from PySide6.QtWidgets import QFileDialog, QLabel, QPushButton

from kagezou.ui.system import language
from kagezou.ui.system.language import Language, system_language
from kagezou.ui.system.qt_words import OF_QT


@pytest.mark.parametrize(
    ("system", "code"),
    [
        (["ja-JP", "ja", "en-US"], "ja"),
        (["ja-Jpan-JP"], "ja"),
        (["xx-XX", "ja-JP", "en"], "ja"),
        (["en-GB", "ja-JP"], "en"),
        (["xx-XX"], "en"),
        ([], "en"),
    ],
)
def test_the_first_language_of_the_system_that_is_spoken(
    monkeypatch: pytest.MonkeyPatch, system: list[str], code: str
) -> None:
    locale = SimpleNamespace(uiLanguages=lambda: system)
    monkeypatch.setattr(language, "QLocale", SimpleNamespace(system=lambda: locale))
    assert system_language() == code


class Listener(QObject):
    """What translators are installed in."""

    def __init__(self) -> None:
        super().__init__()
        self.installed: list[QTranslator] = []
        self.removed: list[QTranslator] = []

    def installTranslator(self, translator: QTranslator) -> None:
        self.installed.append(translator)

    def removeTranslator(self, translator: QTranslator) -> None:
        self.removed.append(translator)


@pytest.mark.usefixtures("qapp")
def test_every_translator_is_taken_away_once() -> None:
    listener = Listener()
    spoken = Language(listener)  # type: ignore[arg-type]
    spoken.speak("ja")
    assert listener.installed
    assert spoken.code == "ja"
    spoken.speak("en")
    spoken.fall_silent()
    assert listener.removed == listener.installed


def test_another_language_than_there_is_means_the_system_s(monkeypatch: pytest.MonkeyPatch) -> None:
    application = QCoreApplication.instance()
    assert application is not None
    monkeypatch.setattr(language, "system_language", lambda: "ja")
    spoken = Language(application)
    for chosen in ("", "xx"):
        spoken.speak(chosen)
        assert spoken.code == "ja"
    spoken.fall_silent()


def test_a_file_dialog_is_of_one_language_whole(english: Language, tmp_path: Path) -> None:
    english.speak("ja")
    (tmp_path / "cels").mkdir()
    for name in ("a.png", "b.kage"):
        (tmp_path / name).touch()
    dialog = QFileDialog(None, "", str(tmp_path))
    labels = {label.objectName(): label.text() for label in dialog.findChildren(QLabel) if label.text()}
    assert set(labels) == {"lookInLabel", "fileNameLabel", "fileTypeLabel"}
    words = [*labels.values(), *(button.text() for button in dialog.findChildren(QPushButton) if button.text())]
    words += [QCoreApplication.translate(*each) for each in OF_QT]
    for text in words:
        assert not re.search(r"[A-Za-z]{4,}", text), text
    dialog.deleteLater()
