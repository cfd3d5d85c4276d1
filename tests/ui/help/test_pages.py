"""The manual's files: every page in every language, every link, every command and every property that it names."""

import re
from itertools import chain

import pytest
from PySide6.QtCore import QCoreApplication

from kagezou.document.properties import TABLE
from kagezou.locations import manual_folder
from kagezou.ui.commands.table import all_commands, command_groups
from kagezou.ui.help.pages import FIRST, pages_in, sections_of, with_properties
from kagezou.ui.panels.filter_pictures import COMPANIONS, EXAMPLES, picture_of
from kagezou.ui.system.language import Language
from kagezou.ui.system.menu_words import plain
from kagezou.ui.system.words import translated
from kagezou.ui.window.wiring.help import sections

LANGUAGES = ("en", "ja")
_MENUS = ("F&ile", "&Edit", "&Keys", "&Drawings", "Fi&gure", "La&yer", "&Set", "&View", "&Playback", "&Help")
_NAMED = {"en": re.compile(r"(?<!\*)\*(\w[\w ]*), ([^*]+)\*(?!\*)"), "ja": re.compile(r"［([^］]+)］＞［([^］]+)］")}
_OF_AFTER_EFFECTS = {"Scripts, Run Script File", "スクリプト"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_file_is_a_page_that_the_contents_link(language: str) -> None:
    files = {path.stem for path in (manual_folder() / language).glob("*.md")}
    assert files == set(pages_in(language))
    assert pages_in(language).keys() == pages_in("en").keys()


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_command_that_is_named_is_one(language: str, english: Language) -> None:
    english.speak(language)
    commands = {plain(command.text) for command in all_commands(command_groups())}
    commands.add(plain(QCoreApplication.translate("Menus", "Preview &Resolution")))
    menus = {plain(QCoreApplication.translate("Menus", menu)) for menu in _MENUS}
    text = " ".join(chain.from_iterable(page.text.split() for page in pages_in(language).values()))
    named = _NAMED[language].findall(text)
    named = [(menu, command) for menu, command in named if command not in _OF_AFTER_EFFECTS]
    assert len(named) > 10
    assert [each for each in named if each[0] in menus and each[1] not in commands] == []
    assert [each for each in named if each[0] not in menus] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_property_is_explained_once(language: str) -> None:
    explained = [name for page in pages_in(language).values() for name in sections_of(page.text)]
    assert sorted(explained) == sorted(sections())
    assert sorted(prop.name for prop in chain(*sections().values())) == sorted(prop.name for prop in TABLE)


def test_a_property_is_written_with_its_range_and_path(english: Language) -> None:
    assert english.code == "en"
    written = with_properties(pages_in("en")["shape"].text, sections())
    assert (
        "- **Softness**: Width of the edge; 0 is a crisp cel edge. (`layers.NAME.shadow.softness`, 0 – 200 px)"
        in written
    )
    assert "<!--" not in written
    written = with_properties(pages_in("en")["light"].text, sections())
    assert "(`light.kind`, Lamp / Sun)" in written
    assert "(`light.position`, px)" in written


def test_an_unknown_section_is_no_empty_list() -> None:
    with pytest.raises(KeyError):
        with_properties("<!-- properties: nothing -->", sections())


def test_the_end_of_a_line_is_no_space_in_japanese() -> None:
    text = pages_in("ja")["first-cut"].text
    assert "後の手順が前の手順を取り消すことはありません" in text
    assert not re.search(r"[ぁ-ん]\n[ぁ-ん]", re.sub(r"```.*?```", "", text, flags=re.DOTALL))
    assert text.count("\n## ") == 7, "headings stay on lines of their own"


def test_what_is_not_translated_is_there_in_english() -> None:
    assert pages_in("no-such-language")[FIRST].title == "Kagezou Manual"


def test_every_filter_has_its_picture() -> None:
    names = {prop.name for prop in TABLE}
    assert EXAMPLES.keys() <= names
    assert set(chain(COMPANIONS, *COMPANIONS.values())) <= names
    assert [name for name in EXAMPLES if not picture_of(name).is_file()] == []
    for path in (manual_folder() / "pictures").glob("*.png"):
        assert path.stem in EXAMPLES, path.name


def test_labels_are_told_apart_within_a_page(english: Language) -> None:
    """F1 finds a property by its name: within a section no two bear one."""
    for language in LANGUAGES:
        english.speak(language)
        for name, props in sections().items():
            labels = [translated(prop.label) for prop in props]
            assert len(set(labels)) == len(labels), (language, name)
