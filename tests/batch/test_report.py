"""The report: one page with all in it, in two languages, safe with any names."""

import re
from dataclasses import replace
from datetime import UTC, datetime
from html.parser import HTMLParser
from pathlib import Path

import pytest

from kagezou.batch.record import RECORD_NAME, CutRecord, State, Thumbnail, read_record, write_record
from kagezou.batch.report import report_page, write_report
from kagezou.batch.told import json_of_message, message_of_json
from kagezou.errors import InputProblem
from kagezou.message import Message

NOW = datetime(2026, 11, 29, 12, 5, tzinfo=UTC)
NASTY = "<i>\"&'</i> 歩き #1?%"
RECORD = CutRecord(
    name=NASTY,
    state=State.DONE,
    notes=(Message("{path}: {cause}", path=NASTY, cause=Message("permission denied")),),
    doubtful=(("A", (3, 4)),),
    layers=("A", NASTY),
    frames=48,
    rate=24.0,
    size_px=(1920, 1080),
    seconds=75.0,
    project="c.kage",
    where="c.jsx",
    counts=((Message("shadow frames"), 48, 48),),
    thumbnails=(Thumbnail(1, b"\xff\xd8one"), Thumbnail(3, b"\xff\xd8two", is_doubtful=True)),
)


class Elements(HTMLParser):
    """The tags of a page, in order, with their attributes, and what of them is open."""

    VOID = ("meta", "img", "input")

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.text = ""
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data

    def values(self, tag: str, name: str) -> list[str | None]:
        return [attrs[name] for each, attrs in self.found if each == tag and name in attrs]


@pytest.mark.parametrize("language", ["en", "ja"])
def test_the_page_is_whole_loads_nothing_and_shows_names_as_text(language: str) -> None:
    page = report_page([RECORD], NASTY, language, NOW)
    elements = Elements(page)
    assert elements.open == []
    assert "i" not in {tag for tag, _ in elements.found}
    assert elements.text.count(NASTY) >= 4
    assert all(str(each).startswith("data:image/jpeg;base64,") for each in elements.values("img", "src"))
    assert not elements.values("script", "src") + elements.values("link", "href")
    assert re.search(r"url\(|@import|https?:", page) is None
    links = elements.values("a", "href")
    assert len(links) == 2
    assert all(str(link).startswith("./%3Ci%3E") and "#" not in str(link) for link in links)


def test_the_languages_say_the_same_otherwise() -> None:
    english, japanese = (Elements(report_page([RECORD], "ep", code, NOW)) for code in ("en", "ja"))
    assert [tag for tag, _ in english.found] == [tag for tag, _ in japanese.found]
    assert "permission denied" in english.text
    assert "permission denied" not in japanese.text


def test_what_is_worst_comes_first_and_is_counted() -> None:
    failed = CutRecord(name="bad", state=State.FAILED, problem=Message("it does not exist"))
    page = report_page(
        [replace(RECORD, name="good"), failed, CutRecord(name="next", state=State.WAITING)], "ep", "en", NOW
    )
    assert re.findall(r"<h2>(\w+)</h2>", page) == ["bad", "next", "good"]
    assert '<li class="failed"><b>1</b>' in page
    assert "It does not exist" in page
    assert 'http-equiv="refresh"' in page, "while cuts are made"
    assert 'http-equiv="refresh"' not in report_page([RECORD, failed], "ep", "en", NOW)


def test_no_cuts_are_a_page_as_well(tmp_path: Path) -> None:
    page = write_report([], tmp_path, "en", NOW).read_text(encoding="utf-8")
    assert "There are no cuts." in page


def test_a_record_comes_back_as_it_was(tmp_path: Path) -> None:
    folder = tmp_path / "c1"
    folder.mkdir()
    write_record(replace(RECORD, name="c1"), folder)
    found = read_record(folder)
    assert found is not None
    assert replace(found, notes=()) == replace(RECORD, name="c1", notes=())
    assert [str(note) for note in found.notes] == [str(note) for note in RECORD.notes]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"kagezou_cut": 1', '"kagezou_cut": 2'),
        ('"project": "c.kage"', '"project": "../../c.kage"'),
        ('"where": "c.jsx"', '"where": "javascript:alert(1)"'),
        ('"where": "c.jsx"', '"where": "/etc/passwd"'),
        ('"state": "done"', '"state": "fine"'),
        ("{", "["),
        ('"frames": 48', '"frames": "many"'),
    ],
)
def test_a_record_that_is_none_counts_for_nothing(tmp_path: Path, old: str, new: str) -> None:
    write_record(RECORD, tmp_path)
    path = tmp_path / RECORD_NAME
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    assert read_record(tmp_path) is None


def test_messages_go_and_come_with_all_within() -> None:
    inner = InputProblem(Message("it is larger than {megabytes} MB", megabytes=32))
    message = Message("{path}: {cause} ({share:.1f})", "about", path=Path("a"), cause=inner, share=0.25)
    assert str(message_of_json(json_of_message(message))) == "a: it is larger than 32 MB (0.2)"
    assert message_of_json(json_of_message(message)).about == "about"


@pytest.mark.parametrize(
    "tree",
    [
        None,
        "text",
        {"text": "{a}", "about": "", "values": {}},
        {"text": "{a.real}", "about": "", "values": {"a": "x"}},
        {"text": "{", "about": "", "values": {}},
        {"text": "{a:d}", "about": "", "values": {"a": "x"}},
    ],
)
def test_what_is_no_message_is_said_as_it_stands(tree: object) -> None:
    assert str(message_of_json(tree)) == str(tree)
