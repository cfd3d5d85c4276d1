"""Files of shortcuts: those of the program, a round trip, and what is none."""

import json
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.local_name import LocalName
from kagezou.errors import InputProblem, ProjectProblem
from kagezou.io.clips.shortcut_files import (
    KeySet,
    bundled_key_sets,
    keys_from_text,
    load_key_set,
    save_key_set,
    text_of_keys,
)

GOOD = {"shortcuts": 1, "name": {"en": "Mine", "ja": "自分"}, "keys": {"save": ["Ctrl+S"]}}


def test_four_programs_keys_come_with_the_program() -> None:
    sets = bundled_key_sets()
    assert [each.code for each in sets] == ["after-effects", "opentoonz", "harmony", "blender"]
    assert sets[0].keys == {}
    assert all(each.keys for each in sets[1:])


@given(st.dictionaries(st.text(min_size=1, max_size=20), st.lists(st.text(min_size=1, max_size=20), max_size=8)))
def test_keys_become_text_and_back(keys: dict[str, list[str]]) -> None:
    given_keys = {name: tuple(each) for name, each in keys.items()}
    assert dict(keys_from_text(text_of_keys(given_keys))) == given_keys


def test_a_file_is_read_as_it_was_written(tmp_path: Path) -> None:
    path = tmp_path / "mine.json"
    save_key_set(path, KeySet("mine", LocalName("Mine", {"ja": "自分"}), {"save": ("Ctrl+S", "F2"), "play": ()}))
    assert load_key_set(path) == KeySet(
        "mine", LocalName("Mine", {"ja": "自分"}), {"save": ("Ctrl+S", "F2"), "play": ()}
    )
    assert [file.name for file in tmp_path.iterdir()] == ["mine.json"]


@pytest.mark.parametrize(
    ("content", "cause"),
    [
        (b"", "empty"),
        (b"\xff\xfe", "UTF-8"),
        (b"[]", "object"),
        (json.dumps({**GOOD, "shortcuts": 2}).encode(), "whole number"),
        (json.dumps({**GOOD, "keys": {"save": "Ctrl+S"}}).encode(), "keys.save"),
        (json.dumps({**GOOD, "keys": {"save": [1]}}).encode(), "keys.save[0]"),
        (json.dumps({**GOOD, "keys": {f"c{each}": [] for each in range(1001)}}).encode(), "more than 1000"),
        (json.dumps({**GOOD, "more": 1}).encode(), "'more'"),
        (b" " * 300_000, "too large"),
    ],
)
def test_what_holds_no_shortcuts_is_said_in_a_sentence(tmp_path: Path, content: bytes, cause: str) -> None:
    path = tmp_path / "mine.json"
    path.write_bytes(content)
    with pytest.raises(InputProblem, match=r"mine\.json does not hold shortcuts") as caught:
        load_key_set(path)
    assert cause in str(caught.value)


def test_a_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match=r"none\.json cannot be read"):
        load_key_set(tmp_path / "none.json")


def test_text_that_holds_something_else_is_refused() -> None:
    with pytest.raises(ProjectProblem):
        keys_from_text("[1]")
