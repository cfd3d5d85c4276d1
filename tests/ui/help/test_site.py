"""The manual as a website: its pages before Sphinx makes them."""

import re
import sys
from pathlib import Path

import pytest

import dev_site
import dev_site_commands
from dev_site_project_file import in_japanese
from dev_site_properties import properties_page
from kagezou.cli.main import VERBS
from kagezou.document.properties import TABLE
from kagezou.io.project.format import description
from kagezou.ui.system.language import Language


@pytest.mark.parametrize("language", dev_site.LANGUAGES)
def test_the_website_has_every_page_and_leads_nowhere_else(
    language: str, tmp_path: Path, english: Language, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    names = dev_site.write_pages(tmp_path / language, language)
    english.speak("en")
    assert {"index", "properties", "commands", "project-file", "light"} <= set(names)
    beside = {
        path.relative_to(dev_site.ROOT / "docs").as_posix()
        for folder in ("pictures", "scripts")
        for path in (dev_site.ROOT / "docs" / folder).rglob("*")
    }
    for name in names:
        text = (tmp_path / language / f"{name}.md").read_text(encoding="utf-8")
        assert "<!-- properties" not in text
        for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", re.sub(r"```.*?```|`[^`]*`", "", text, flags=re.DOTALL)):
            assert target.startswith("http") or target.removesuffix(".md") in names or target in beside, (name, target)


@pytest.mark.parametrize("language", dev_site.LANGUAGES)
def test_the_reference_has_every_property_with_its_values(language: str, english: Language) -> None:
    english.speak(language)
    lines = list(properties_page(language))
    rows = [line for line in lines if re.match(r"\| [^|]+ \| `", line)]
    english.speak("en")
    assert len(rows) == len(TABLE)
    assert all(row.count(" | ") == 4 and "|  |" not in row for row in rows)
    (softness,) = (row for row in rows if "`layers.NAME.shadow.softness`" in row)
    assert "| 0 – 200 px | `0` |" in softness
    (kind,) = (row for row in rows if "| `light.kind` |" in row)
    assert kind.count("`") == 8, "its path, both choices and the default"
    if language == "ja":
        assert all(any(ord(sign) > 0x3000 for sign in row) for row in rows)


def test_the_project_file_is_described_in_japanese_row_by_row(english: Language) -> None:
    english.speak("ja")
    text = in_japanese(description())
    english.speak("en")
    english_rows, rows = (re.findall(r"^\| (`[^`]+`) \|", each, re.MULTILINE) for each in (description(), text))
    assert rows == english_rows
    left = re.compile(r"[a-z]{3,} [a-z]{2,} [a-z]{2,}")
    assert [line for line in text.split("```")[0].splitlines() if left.search(line)] == []
    softness = next(line for line in text.splitlines() if line.startswith("| `shadow.softness`"))
    assert "| 数、0～200 px | `0.0` |" in softness
    assert "エッジの幅" in softness


def test_every_command_is_explained_in_both_languages() -> None:
    words = dev_site_commands.catalogue()
    assert list(words["summaries"]) == list(VERBS)
    assert set(words["texts"]) == dev_site_commands.english_texts()
    for texts in words.values():
        assert [each for each in texts.values() if not any(ord(sign) > 0x3000 for sign in each)] == []


def test_the_japanese_reference_has_every_option_and_example_of_the_english_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    of_english, of_japanese = ("\n".join(dev_site_commands.commands_page(each)) for each in ("en", "ja"))
    for wanted in (r"(?<![\w-])--[a-z-]+", r"(?m)^ *(kagezou .*?)(?= {4,}|$)"):
        assert set(re.findall(wanted, of_english)) <= set(re.findall(wanted, of_japanese))
    words = re.sub(r"```.*?```|`[^`]*`", "", of_japanese, flags=re.DOTALL)
    left = re.compile(r"[a-z]{3,} [a-z]{2,} [a-z]{2,}")
    assert [line for line in words.splitlines() if left.search(line)] == []


def test_the_reference_shows_what_a_command_says_itself(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    lines = "\n".join(dev_site_commands.commands_page("en"))
    assert "## kagezou render" in lines
    assert "--start-frame N" in lines
    assert capsys.readouterr().out == ""
    assert str(tmp_path) not in lines
    assert sys.prefix not in lines
