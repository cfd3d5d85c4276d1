"""The shortcuts: the table, the sets of other programs, the user's changes, and finding a command by its letters."""

from collections.abc import Iterable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.local_name import LocalName
from kagezou.io.clips.shortcut_files import KeySet, bundled_key_sets
from kagezou.ui.commands.fuzzy import score
from kagezou.ui.commands.shortcut_keys import RESERVED, UNSURE
from kagezou.ui.commands.shortcut_scheme import Shortcuts, overlaid, spelling, table_of
from kagezou.ui.commands.table import all_commands, command_groups
from kagezou.ui.system.language import Language
from kagezou.ui.system.menu_words import plain

COMMANDS = all_commands(command_groups())
TABLE = table_of(COMMANDS)
SETS = bundled_key_sets()
NAMES, KEYS = ("a", "b", "c", "d"), ("A", "B", "C", "F1", "Ctrl+A", "Ctrl+B")
MNEMONICS = {"Alt+I", "Alt+E", "Alt+K", "Alt+S", "Alt+V", "Alt+P", "Alt+H"}


def set_of(keys: dict[str, tuple[str, ...]]) -> KeySet:
    return KeySet("", LocalName(""), keys)


def all_keys(keys: Iterable[tuple[str, ...]]) -> list[str]:
    return [key for each in keys for key in each]


some_keys = st.dictionaries(st.sampled_from(NAMES), st.lists(st.sampled_from(KEYS), max_size=3).map(tuple))
whole_tables = some_keys.map(lambda keys: overlaid(dict.fromkeys(NAMES, ()), keys))


def test_every_command_has_a_name_and_words_of_its_own() -> None:
    assert len({command.name for command in COMMANDS}) == len(COMMANDS)
    assert len({plain(command.source) for command in COMMANDS}) == len(COMMANDS)


def test_no_two_commands_of_the_table_share_a_key() -> None:
    keys = all_keys(command.keys for command in COMMANDS)
    assert len(set(keys)) == len(keys)


@pytest.mark.parametrize("key_set", SETS, ids=lambda each: each.code)
class TestSets:
    def test_keys_are_spelled_as_qt_does_and_commands_are_known(self, key_set: KeySet) -> None:
        assert set(key_set.keys) <= set(TABLE)
        assert all(spelling(key) == key for key in all_keys(key_set.keys.values()))

    def test_no_key_lies_on_two_commands(self, key_set: KeySet) -> None:
        keys = all_keys(Shortcuts(TABLE, key_set, {}).keys.values())
        assert len(set(keys)) == len(keys)
        assert len(set(all_keys(key_set.keys.values()))) == len(all_keys(key_set.keys.values()))

    def test_no_command_loses_its_keys_to_another_unsaid(self, key_set: KeySet) -> None:
        keys = Shortcuts(TABLE, key_set, {}).keys
        assert [name for name in TABLE if TABLE[name] and not keys[name]] == []

    def test_nothing_lies_only_on_keys_that_some_keyboards_lack(self, key_set: KeySet) -> None:
        keys = Shortcuts(TABLE, key_set, {}).keys
        unsure = {name: each for name, each in keys.items() if each and all(key[-1] in UNSURE for key in each)}
        assert unsure == {}

    def test_menus_and_picture_keep_their_own_keys(self, key_set: KeySet) -> None:
        keys = set(all_keys(Shortcuts(TABLE, key_set, {}).keys.values()))
        assert not keys & RESERVED
        assert not keys & MNEMONICS


class TestOwn:
    @given(whole_tables, some_keys, some_keys, st.sampled_from(NAMES), st.sampled_from(KEYS))
    def test_a_key_given_lies_there_and_nowhere_else(
        self,
        table: dict[str, tuple[str, ...]],
        upper: dict[str, tuple[str, ...]],
        own: dict[str, tuple[str, ...]],
        name: str,
        key: str,
    ) -> None:
        before = Shortcuts(table, set_of(upper), {}).with_keys(own)
        after = before.given(name, key)
        assert after.owner(key) == name
        assert len(set(all_keys(after.keys.values()))) == len(all_keys(after.keys.values()))
        others = {other: tuple(each for each in keys if each != key) for other, keys in before.keys.items()}
        assert {other: keys for other, keys in after.keys.items() if other != name} == {
            other: keys for other, keys in others.items() if other != name
        }
        assert after.taken(name, key).owner(key) is None

    @given(whole_tables, some_keys, some_keys)
    def test_a_reset_command_has_the_sets_keys(
        self,
        table: dict[str, tuple[str, ...]],
        upper: dict[str, tuple[str, ...]],
        own: dict[str, tuple[str, ...]],
    ) -> None:
        shortcuts = Shortcuts(table, set_of(upper), {}).with_keys(own)
        for name in NAMES:
            shortcuts = shortcuts.reset(name)
            assert shortcuts.keys[name] == shortcuts.of_the_set[name]
            assert not shortcuts.is_own(name)
        assert shortcuts.own == {}

    def test_unknown_commands_and_keys_of_a_file_are_left_out(self) -> None:
        shortcuts = Shortcuts(TABLE, SETS[0], {}).with_keys({"no such": ("F2",), "save": ("Ctrl+Nothing", "F12")})
        assert shortcuts.own == {"save": ("F12",)}


class TestFinding:
    @pytest.mark.parametrize(
        ("typed", "text"),
        [
            ("save", "Save As"),
            ("as sav", "Save As"),
            ("SVA", "Save As"),
            ("ｓａｖｅ", "Save As"),
            ("ずーむ", "ズームイン"),
            ("書き", "影レイヤーを書き出し"),
            ("100", "Actual Pixels (100 %)"),
            ("", "Anything"),
        ],
    )
    def test_letters_fit(self, typed: str, text: str) -> None:
        assert score(typed, text) is not None

    @pytest.mark.parametrize(("typed", "text"), [("xyz", "Save As"), ("as", "Undo"), ("save z", "Save As")])
    def test_letters_do_not_fit(self, typed: str, text: str) -> None:
        assert score(typed, text) is None

    def test_the_plainest_fit_is_first(self) -> None:
        words = ["Paste Keys at Playhead", "Play Every Frame", "Display", "Play / Stop", "Play"]
        fits = {text: found for text in words if (found := score("play", text)) is not None}
        assert sorted(fits, key=lambda text: -fits[text]) == [
            "Play",
            "Play / Stop",
            "Play Every Frame",
            "Paste Keys at Playhead",
            "Display",
        ]

    @given(st.text(max_size=8), st.text(max_size=16))
    def test_a_text_fits_itself_better_than_anything_else(self, typed: str, text: str) -> None:
        found = score(typed, text)
        assert found is None or not typed.strip() or (score(typed, typed) or 0) >= found


def test_commands_are_said_in_the_language_of_the_window(english: Language) -> None:
    save = next(command for command in COMMANDS if command.name == "save")
    assert save.text == "&Save"
    english.speak("ja")
    assert save.text == "保存(&S)"
    assert save.source == "&Save"
