"""Names as runs: whatever stands around the numbers, one sequence is one, and two are two."""

import hashlib
import random
import unicodedata

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.io.names.runs import Runs, number_in, runs_of


def told(names: tuple[str, ...]) -> dict[str, list[str]]:
    """Return the names of each run in order, by the run's name."""
    found = runs_of(names)
    return {run.name: [names[place.index] for place in run.places] for run in found.runs}


def notes_of(names: tuple[str, ...]) -> list[str]:
    return [str(note) for run in runs_of(names).runs for note in run.notes]


@pytest.mark.parametrize(
    ("name", "names"),
    [
        ("img", ("img_-0003", "img_-0002", "img_-0001")),
        ("", ("-2", "-1", "0", "1")),
        ("A", ("A_0001_col", "A_0002_col", "A_0003_col")),
        ("A", ("A_0001_v2", "A_0002_v2")),
        ("A", ("A_0001_v1", "A_0002_v2", "A_0003")),
        ("", ("00000001", "00000002", "00000010")),
        ("A", ("A000000000001", "A000000000002")),
        ("A", ("A (1)", "A (2)", "A (10)")),
        ("A1", ("A1 (1)", "A1 (2)")),
        ("A", ("A0001 (1)", "A0002 (1)")),
        ("A", ("A0001 - Copy", "A0002 - Copy (2)", "A0003 - コピー")),
        ("[A]", ("[A] 0001", "[A] 0002")),
        ("A", ("A[0001]", "A[0002]")),
        ("20260101_A", ("20260101_A_0001", "20260101_A_0002")),
        ("A", ("A_0001_20260101", "A_0002_20260131")),
        ("A", ("A_0001_1920x1080", "A_0002_1920x1080", "A_0003_2k")),
        ("4k_A", ("4k_A_0001", "4k_A_0002")),
        ("A", ("A_0001_103022", "A_0002_103059", "A_0003_103101")),
        ("A", ("A_0001_3fa9bc", "A_0002_77ce01", "A_0003_a0b1c2")),
        ("A", ("A_0001_smile", "A_0002_cry", "A_0003")),
        ("girl", ("girl_smile_0001", "girl_cry_0002", "girl_angry_0003")),
        ("A", ("A", "0001_A", "0002_A")[1:]),
        ("Ａ", ("Ａ０００１", "Ａ０００２", "A0003")),
        ("A", ("A0001", "a0002", "A-0003", "A_0004")),
        ("c012_A", ("c012_A_0001", "c012_A_0002")),
        ("walk_v", ("walk_v1", "walk_v2")),
        ("A", ("A0000", "A0001", "A0001a", "A0001b", "A0002")),
        ("", ("①", "②")),
        ("c012", ("c012_20260130", "c012_20260131", "c012_20260132")),
        ("c012", ("c012_20260101", "c012_20260102", "c012_20260103")),
        ("", ("1", "1.5", "2")),
        ("A", ("A_0001", "A_0001.5", "A_0002")),
        ("A", ("A0001a", "A0001b", "A0002a")),
        ("A", ("A-0002", "A-0001", "A0000", "A0001", "A0002")),
    ],
)
def test_one_sequence(name: str, names: tuple[str, ...]) -> None:
    mixed = list(names)
    random.Random(3).shuffle(mixed)
    assert told(tuple(mixed)) == {name: list(names)}
    assert runs_of(names).unnumbered == ()


@pytest.mark.parametrize(
    ("names", "runs"),
    [
        (("A0001", "A0002", "B0001", "B0002"), {"A": ["A0001", "A0002"], "B": ["B0001", "B0002"]}),
        (("A0001", "B0001"), {"A": ["A0001"], "B": ["B0001"]}),
        (("A_0001_line", "A_0001_col"), {"A_line": ["A_0001_line"], "A_col": ["A_0001_col"]}),
        (("hand_1_L", "hand_1_R"), {"hand_L": ["hand_1_L"], "hand_R": ["hand_1_R"]}),
        (("1A", "2A", "1B", "2B"), {"A": ["1A", "2A"], "B": ["1B", "2B"]}),
        (
            ("A_1_line", "A_2_line", "A_1_col_v2", "A_2_col_v2"),
            {"A_line": ["A_1_line", "A_2_line"], "A_col": ["A_1_col_v2", "A_2_col_v2"]},
        ),
        (("1_A", "2_A", "1_B"), {"A": ["1_A", "2_A"], "B": ["1_B"]}),
        (
            ("c012_A_1", "c012_A_2", "c013_A_1", "c013_A_2"),
            {"c012_A": ["c012_A_1", "c012_A_2"], "c013_A": ["c013_A_1", "c013_A_2"]},
        ),
        (("A1_1", "A1_2", "A2_3", "A2_4", "A2_5"), {"A1": ["A1_1", "A1_2"], "A2": ["A2_3", "A2_4", "A2_5"]}),
        (("A0001", "A0002", "a0001", "a0002"), {"A": ["A0001", "A0002"], "a": ["a0001", "a0002"]}),
        (
            ("12_0001", "12_0002", "12_0003", "13_0001", "13_0002", "13_0003"),
            {"12": ["12_0001", "12_0002", "12_0003"], "13": ["13_0001", "13_0002", "13_0003"]},
        ),
        (
            ("f1_1", "f1_2", "f2_1", "f2_2", "f3_1", "f3_2"),
            {"f_1": ["f1_1", "f2_1", "f3_1"], "f_2": ["f1_2", "f2_2", "f3_2"]},
        ),
        (("walk1", "walk2", "run1"), {"walk": ["walk1", "walk2"], "run": ["run1"]}),
    ],
)
def test_different_characters_stay_different(names: tuple[str, ...], runs: dict[str, list[str]]) -> None:
    assert told(names) == runs


@pytest.mark.parametrize(
    ("names", "kept", "note"),
    [
        (("A0001", "A0002", "A0002_R1"), ["A0001", "A0002_R1"], "newest retake counts: A0002 → A0002_R1"),
        (("A0002", "A0002r2", "A0002r10"), ["A0002r10"], "newest retake counts: "),
        (("A0001", "A0002_retake2", "A0002"), ["A0001", "A0002_retake2"], "newest retake counts: "),
        (("A0001", "A0002_v2", "A0002", "A0002_v1"), ["A0001", "A0002_v2"], "newest retake counts: "),
        (("A0001", "A0002", "A0002リテイク"), ["A0001", "A0002リテイク"], "newest retake counts: "),
        (("A0001", "A0002", "A0002R"), ["A0001", "A0002R"], "newest retake counts: "),
        (("A0001", "A0002_old", "A0002"), ["A0001", "A0002"], "newest retake counts: A0002_old → A0002"),
        (("A1_20260101", "A1_20260215"), ["A1_20260215"], "newest retake counts: "),
        (("A0001", "A0001 - Copy"), ["A0001"], "only one counts: A0001 - Copy → A0001"),
        (("A0001", "A0001 (2)", "A0002"), ["A0001", "A0002"], "only one counts: A0001 (2) → A0001"),
        (("A0001", "コピー ~ A0001"), ["A0001"], "only one counts: "),
        (("001", "002", "1"), ["001", "002"], "only one counts: 1 → 001"),
        (("A0001", "A0002", "A0003", "A0001_ref"), ["A0001", "A0002", "A0003"], "only one counts: A0001_ref → A0001"),
        (("A0001", "A0002", "A0002_2"), ["A0001", "A0002_2"], "newest retake counts: A0002 → A0002_2"),
        (("walk_v1_1", "walk_v1_2", "walk_v2_1"), ["walk_v2_1"], "newest version counts; older drawings left out: 2"),
        (("a_v1_1", "a_v2_2"), ["a_v1_1", "a_v2_2"], ""),
    ],
)
def test_the_newest_counts_and_what_does_not_is_said(names: tuple[str, ...], kept: list[str], note: str) -> None:
    assert list(told(names).values()) == [kept]
    assert not note or any(note in each for each in notes_of(names))


@pytest.mark.parametrize(
    ("names", "note"),
    [
        (("img_-1", "img_-2"), "a dash before a number is taken as a minus: img_-2"),
        (("walk_v1", "walk_v2"), "what looks like a version is taken as the drawing's number: walk_v1"),
        (("A_0001_17", "A_0002_99"), "several numbers run; the drawing's is taken to be 1 in A_0001_17"),
        (("A_1_x", "A_2_y"), "one sequence, although the words in its names differ: A_1_x, A_2_y"),
    ],
)
def test_doubts_are_said(names: tuple[str, ...], note: str) -> None:
    assert notes_of(names) == [note]


def test_figures_of_a_hash_behind_each_number_tear_nothing_apart() -> None:
    names = tuple(f"A_{number:04d}_{hashlib.md5(bytes([number])).hexdigest()[:6]}" for number in range(1, 200))
    assert told(names) == {"A": list(names)}


def test_what_has_no_number_is_told_apart() -> None:
    names = ("layout", "A1", "A2", "bg_v2", "20260101", "plate_1920x1080")
    assert runs_of(names).unnumbered == (0, 3, 4, 5)
    assert runs_of(("9" * 40, "x" * 5000)).runs == ()
    assert runs_of(()) == Runs((), ())


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("12", (12, "")),
        ("01A", (1, "a")),
        ("Ａ０２ｂ", (2, "b")),
        ("c012_A_0003", (3, "")),
        ("A (4)", (4, "")),
        ("A_0005_v2", (5, "")),
        ("v3", (3, "")),
        ("A0006r1", (6, "")),
        ("x", None),
    ],
)
def test_one_name_by_itself(name: str, number: tuple[int, str] | None) -> None:
    assert number_in(name) == number


_WORDS = st.sampled_from(["A", "walk", "kid run", "ガール", "ﾊﾟｰﾂ", "éa", "c012_A", "影", "B_side", "Ｃ", "20260101_A"])
_TAILS = st.sampled_from(["", "_col", "_v2", " paint", "_1920x1080", ".line", "_20260101", "[x]", "_ガ", "_ver03"])
_WIDE = str.maketrans("0123456789", "０１２３４５６７８９")


@st.composite
def sequences(draw: st.DrawFn, words: st.SearchStrategy[str] = _WORDS) -> tuple[list[str], list[int]]:
    """Draw the names of a sequence and its numbers, both in order."""
    first = draw(st.integers(-20, 12_000) | st.integers(10_000_000, 20_400_000))
    step = draw(st.integers(1, 3))
    numbers = [first + step * index for index in range(draw(st.integers(2, 12)))]
    digits, word, tail = draw(st.sampled_from([1, 2, 4, 5, 8])), draw(words), draw(_TAILS)
    between = (
        draw(st.sampled_from(["_", ".", "_", "("])) if first < 0 else draw(st.sampled_from(["", "_", "-", " ", "."]))
    )
    between = between or "_" * word[-1:].isdigit()
    names = []
    for number in numbers:
        figures = f"{number:0{digits}d}"
        figures = figures.translate(_WIDE) if draw(st.booleans()) else figures
        names.append(unicodedata.normalize("NFD" if draw(st.booleans()) else "NFC", f"{word}{between}{figures}{tail}"))
    return names, numbers


@given(sequences(), st.randoms(use_true_random=False))
def test_any_sequence_comes_back_in_order(found: tuple[list[str], list[int]], chance: random.Random) -> None:
    names, numbers = found
    mixed = list(names)
    chance.shuffle(mixed)
    result = runs_of(mixed)
    (run,) = result.runs
    assert [place.number for place in run.places] == numbers
    assert [mixed[place.index] for place in run.places] == names
    assert (result.unnumbered, run.replaced, run.twice) == ((), (), ())


@given(sequences(st.just("hero")), sequences(st.just("foe")), st.randoms(use_true_random=False))
def test_two_beginnings_never_mix(
    one: tuple[list[str], list[int]], other: tuple[list[str], list[int]], chance: random.Random
) -> None:
    mixed = [*one[0], *other[0]]
    chance.shuffle(mixed)
    assert told(tuple(mixed)) == {"hero": one[0], "foe": other[0]}


@given(st.lists(st.text("A1２_-. (vrガ)", max_size=8), unique=True, max_size=8), st.randoms(use_true_random=False))
def test_the_order_of_the_listing_says_nothing(names: list[str], chance: random.Random) -> None:
    mixed = list(names)
    chance.shuffle(mixed)

    def shape(listed: list[str]) -> list[tuple[str, list[tuple[str, int, str]]]]:
        return [
            (run.name, [(listed[place.index], place.number, place.insert) for place in run.places])
            for run in runs_of(listed).runs
        ]

    assert shape(mixed) == shape(names)
    found = runs_of(names)
    indices = [place.index for run in found.runs for place in run.places]
    assert len(indices) == len(set(indices)), "no name is two drawings"
    assert not set(indices) & set(found.unnumbered)
