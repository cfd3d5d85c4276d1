"""Every text of the window and every message of the rooms below is in every catalogue, with all its values."""

import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import PySide6
import pytest
from PySide6.QtCore import QCoreApplication, QTranslator

import dev_translations
from kagezou.document.choice_labels import CHOICE_LABELS
from kagezou.document.properties import TABLE
from kagezou.errors import InputProblem, UsageProblem
from kagezou.io.clips.catalogues import messages_in
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.sequences import find_sequences
from kagezou.locations import resource_folder
from kagezou.message import Message
from kagezou.ui.system import language
from kagezou.ui.system.language import Language, languages
from kagezou.ui.system.words import choice_name, translated
from kagezou.ui.window.main_window import MainWindow

FOLDER = resource_folder() / "translations"
CODES = sorted(path.stem.removeprefix("kagezou_") for path in FOLDER.glob("kagezou_*.ts"))
FOREIGN = [code for code in CODES if code != "en"]
SOURCES = sorted(dev_translations.messages())


def texts(path: Path) -> dict[tuple[str, str, str], ET.Element]:
    found = {}
    for context in ET.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            key = (context.findtext("name", ""), message.findtext("source", ""), message.findtext("comment", ""))
            found[key] = message
    return found


@pytest.fixture(scope="module")
def fresh(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The catalogues as the sources would have them now."""
    folder = tmp_path_factory.mktemp("translations")
    for path in FOLDER.glob("kagezou_*.ts"):
        shutil.copy(path, folder)
    dev_translations.update(Path(PySide6.__file__).parent, folder)
    return folder


@pytest.mark.parametrize("code", CODES)
def test_the_catalogue_holds_what_the_sources_say_and_nothing_else(code: str, fresh: Path) -> None:
    name = f"kagezou_{code}.ts"
    assert set(texts(fresh / name)) == set(texts(FOLDER / name)), "run packaging/dev.py translate"


@pytest.mark.parametrize("code", CODES)
def test_every_text_is_translated(code: str) -> None:
    for key, message in texts(FOLDER / f"kagezou_{code}.ts").items():
        translation = message.find("translation")
        assert translation is not None
        forms = ["".join(form.itertext()) for form in translation.iter("numerusform")] or [translation.text or ""]
        assert all(forms), key
        assert translation.get("type") is None, key
        for mark in ("%1", "%2", "%n"):
            assert all((mark in key[1]) == (mark in text) for text in forms), (key, forms)


@pytest.mark.parametrize("code", CODES)
def test_the_compiled_files_are_those_of_the_written_ones(code: str, fresh: Path) -> None:
    kept, made = QTranslator(), QTranslator()
    assert kept.load(str(FOLDER / f"kagezou_{code}.qm"))
    assert made.load(str(fresh / f"kagezou_{code}.qm"))
    for (context, source, comment), message in texts(FOLDER / f"kagezou_{code}.ts").items():
        count = 2 if message.get("numerus") else -1
        said = kept.translate(context, source, comment, count)
        assert said == made.translate(context, source, comment, count) != ""


def test_the_window_and_the_reader_without_qt_say_the_same(english: Language) -> None:
    for code in FOREIGN:
        english.speak(code)
        for text, about in SOURCES:
            assert QCoreApplication.translate("Message", text, about or None) == messages_in(code)(text, about)


def test_a_text_that_does_not_stand_in_its_call_is_named(tmp_path: Path) -> None:
    (tmp_path / "room.py").write_text("text = 'a'\nMessage(text)\n", encoding="utf-8")
    with pytest.raises(ValueError, match=r"room\.py:2: the text of a message stands literally in its call"):
        dev_translations.messages(tmp_path)


def test_a_language_more_is_one_catalogue_more(
    english: Language, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(FOLDER, tmp_path / "translations")
    source = (tmp_path / "translations" / "kagezou_ja.ts").read_text(encoding="utf-8")
    german = (
        source.replace('language="ja"', 'language="de"')
        .replace("<translation>日本語</translation>", "<translation>Deutsch</translation>")
        .replace("<translation>見つかりません</translation>", "<translation>es fehlt</translation>")
    )
    (tmp_path / "translations" / "kagezou_de.ts").write_text(german, encoding="utf-8")
    dev_translations.update(Path(PySide6.__file__).parent, tmp_path / "translations")
    monkeypatch.setattr(language, "resource_folder", lambda: tmp_path)
    for cached in (language.languages, language._catalogues):
        cached.cache_clear()
        monkeypatch.setattr(language, cached.__name__, cached)
    try:
        assert dict(languages()) == {"en": "English", "de": "Deutsch", "ja": "日本語"}
        english.speak("de")
        assert translated(Message("it does not exist")) == "es fehlt"
    finally:
        for cached in (language.languages, language._catalogues):
            cached.cache_clear()


def test_the_table_and_its_choices_are_said_in_the_language_of_the_window(english: Language) -> None:
    assert translated(TABLE[1].label) == "Ground position"
    assert choice_name("steps") == "Steps"
    english.speak("ja")
    assert translated(TABLE[1].label) == "地面の位置"
    assert choice_name("steps") == "階段"
    assert choice_name("no choice of the table") == "no choice of the table"


def test_every_choice_of_the_table_has_a_label() -> None:
    assert {choice for prop in TABLE for choice in prop.choices} <= set(CHOICE_LABELS)


def test_plurals_are_right_in_english() -> None:
    forms = [QCoreApplication.translate("LayerModel", "%n drawing(s)", "", count) for count in (1, 2)]
    assert forms == ["1 drawing", "2 drawings"]


def test_what_really_happens_is_said_in_japanese(english: Language, tmp_path: Path) -> None:
    english.speak("ja")
    (tmp_path / "notes.txt").write_text("no picture", encoding="utf-8")
    with pytest.raises(InputProblem) as missing:
        CelCache().cel(tmp_path / "none.png")
    with pytest.raises(InputProblem) as other:
        find_sequences(tmp_path / "notes.txt")

    assert translated(missing.value) == f"{tmp_path}/none.png：見つかりません"
    assert translated(other.value) == f"{tmp_path}/notes.txt：「.txt」は読み込める画像形式ではありません"
    named = UsageProblem(Message("there is already a layer named {name!r}", name="A"))
    assert translated(named) == "'A' という名前のレイヤーはすでにあります"


def test_a_missing_drawing_is_said_without_english(english: Language) -> None:
    english.speak("ja")
    assert translated(Message("{path}: the drawing is missing", path="a.png")) == "a.png：セルが見つかりません"
    broken = Message("the file is damaged at the layer {layer!r} or of an unknown kind ({cause})", layer="A", cause="x")
    assert translated(broken) == "レイヤー 'A' のところでファイルが壊れているか、未知の種類です（x）"


def test_the_japanese_window_says_why_a_project_does_not_open(
    english: Language, window: MainWindow, tmp_path: Path
) -> None:
    english.speak("ja")

    window.parts.project.open_path(tmp_path / "none.kage")

    assert window.parts.bar.text == f"{tmp_path}/none.kage：見つかりません"
