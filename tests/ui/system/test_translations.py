"""Every text of the window has a Japanese translation, and the compiled files are those of the written ones."""

import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import PySide6
import pytest
from PySide6.QtCore import QCoreApplication, QTranslator

import kagezou.ui
from kagezou.document.properties import TABLE
from kagezou.locations import resource_folder
from kagezou.ui.system.language import LANGUAGES, Language
from kagezou.ui.system.words import choice_word, is_japanese, said

FOLDER = resource_folder() / "translations"
SOURCES = sorted(Path(kagezou.ui.__file__).parent.rglob("*.py"))


def tool(name: str, *arguments: object) -> None:
    suffix = ".exe" if sys.platform == "win32" else ""
    program = Path(PySide6.__file__).parent / f"{name}{suffix}"
    subprocess.run([str(program), *map(str, arguments)], check=True, capture_output=True, timeout=60)


def messages(path: Path) -> dict[tuple[str, str], ET.Element]:
    found = {}
    for context in ET.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            found[context.findtext("name", ""), message.findtext("source", "")] = message
    return found


def test_every_text_of_the_sources_is_translated(tmp_path: Path) -> None:
    tool("lupdate", *SOURCES, "-ts", tmp_path / "fresh.ts", "-locations", "none", "-source-language", "en")
    fresh, kept = set(messages(tmp_path / "fresh.ts")), messages(FOLDER / "kagezou_ja.ts")
    assert fresh == set(kept), "run pyside6-lupdate (see the folder's README)"
    for key, message in kept.items():
        translation = message.find("translation")
        assert translation is not None
        texts = ["".join(form.itertext()) for form in translation.iter("numerusform")] or [translation.text or ""]
        assert all(texts), key
        assert translation.get("type") is None, key
        for mark in ("%1", "%2", "%n"):
            assert all((mark in key[1]) == (mark in text) for text in texts), (key, texts)


@pytest.mark.parametrize("code", LANGUAGES)
def test_the_compiled_files_are_those_of_the_written_ones(code: str, tmp_path: Path) -> None:
    tool("lrelease", FOLDER / f"kagezou_{code}.ts", "-qm", tmp_path / "fresh.qm")
    kept, fresh = QTranslator(), QTranslator()
    assert kept.load(str(FOLDER / f"kagezou_{code}.qm"))
    assert fresh.load(str(tmp_path / "fresh.qm"))
    for (context, source), message in messages(FOLDER / f"kagezou_{code}.ts").items():
        count = 2 if message.get("numerus") else -1
        assert kept.translate(context, source, "", count) == fresh.translate(context, source, "", count) != ""


def test_the_table_and_its_choices_are_said_in_the_language_of_the_window(english: Language) -> None:
    assert said(TABLE[1].label) == "Ground position"
    english.speak("ja")
    assert is_japanese()
    assert said(TABLE[1].label) == "地面の位置"
    for prop in TABLE:
        assert all(choice_word(choice) != choice for choice in prop.choices)


def test_plurals_are_right_in_english() -> None:
    forms = [QCoreApplication.translate("LayerModel", "%n drawing(s)", "", count) for count in (1, 2)]
    assert forms == ["1 drawing", "2 drawings"]
