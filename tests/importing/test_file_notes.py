"""What readers say of many files is said once, with how many files it is about."""

from collections.abc import Sequence
from pathlib import Path

from kagezou.importing.file_notes import said_once
from kagezou.message import Message

PROFILE = Message("its colour profile is not used")
PAGES = Message("only the first of {pages} pages is used", pages=3)


def words(said: Sequence[tuple[Path, tuple[Message, ...]]]) -> list[str]:
    return [str(note) for note in said_once("A", said)]


def test_one_file_is_named() -> None:
    assert words([(Path("a.png"), (PROFILE,)), (Path("b.png"), ())]) == ["a.png: its colour profile is not used"]


def test_what_all_files_share_is_said_of_the_layer() -> None:
    every = [(Path(f"{number}.png"), (PROFILE,)) for number in range(3)]
    assert words(every) == ["A: its colour profile is not used, in all its 3 files"]


def test_what_some_files_share_is_counted() -> None:
    said = [(Path("1.png"), ()), (Path("2.png"), (PROFILE, PAGES)), (Path("3.png"), (PROFILE,))]
    assert words(said) == [
        "A: its colour profile is not used, in 2 of 3 files, first in 2.png",
        "2.png: only the first of 3 pages is used",
    ]


def test_several_drawings_of_one_file_say_it_once() -> None:
    part = (Path("a.psd"), (PAGES,))
    assert words([part, part]) == ["a.psd: only the first of 3 pages is used"]


def test_nothing_said_is_nothing() -> None:
    assert words([(Path("1.png"), ())]) == []
