import os
import random
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.errors import InputProblem
from kagezou.io.images.sequences import Found, find_sequences, natural_key, sequences_among


def touch(folder: Path, *names: str) -> None:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"")


def told(found: Found) -> list[tuple[str, list[tuple[int | None, str, str]]]]:
    return [
        (sequence.name, [(file.number, file.suffix, file.path.name) for file in sequence.files])
        for sequence in found.sequences
    ]


@pytest.mark.parametrize(
    ("names", "name"),
    [
        (("A0001.png", "A0002.PNG", "A0010.png"), "A"),
        (("A_1.png", "A_2.png", "A_10.png"), "A"),
        (("A.0001.tga", "A.0002.tga", "A.0003.TGA"), "A"),
        (("0001.png", "0002.png", "0003.png"), "folder"),
        (("影_001.tif", "影_002.tif", "影_100000.tif"), "影"),
        (("kid run 1.exr", "kid run 2.exr", "kid run 11.exr"), "kid run"),
        (("c1_A-001.webp", "c1_A-002.webp", "c1_A-003.webp"), "c1_A"),
    ],
)
def test_usual_namings(tmp_path: Path, names: tuple[str, ...], name: str) -> None:
    folder = tmp_path / "folder"
    touch(folder, *reversed(names))
    found = find_sequences(folder)
    assert [(sequence.name, [file.path.name for file in sequence.files]) for sequence in found.sequences] == [
        (name, list(names))
    ]
    assert found.left_out == ()


def test_letters_after_the_number_follow_it(tmp_path: Path) -> None:
    touch(tmp_path, "A0001.png", "A0001a.png", "A0001b.png", "A0002.png", "A0002B.png")
    assert told(find_sequences(tmp_path)) == [
        (
            "A",
            [
                (1, "", "A0001.png"),
                (1, "a", "A0001a.png"),
                (1, "b", "A0001b.png"),
                (2, "", "A0002.png"),
                (2, "B", "A0002B.png"),
            ],
        )
    ]


def test_groups_by_prefix_and_reports_the_rest(tmp_path: Path) -> None:
    touch(tmp_path, "A1.png", "A2.png", "A1.tga", "B1.png", "layout.jpg", "notes.txt", "20260101.png")
    found = find_sequences(tmp_path)
    assert [(s.name, [f.path.name for f in s.files]) for s in found.sequences] == [
        ("A", ["A1.png", "A2.png"]),
        ("B", ["B1.png"]),
    ]
    assert [path.name for path in found.left_out] == ["20260101.png", "layout.jpg"]
    assert list(map(str, found.notes)) == ["of two with one number only one counts: A1.tga → A1.png"]


def test_hidden_backup_and_part_files_are_not_seen(tmp_path: Path) -> None:
    touch(tmp_path, "A1.png", ".A2.png", "._A3.png", "A4.png~", ".A5.png.12-0123abcd.part.png", "Thumbs.db")
    (tmp_path / "A6.png").mkdir()
    assert told(find_sequences(tmp_path)) == [("A", [(1, "", "A1.png")])]


def test_folder_of_folders(tmp_path: Path) -> None:
    touch(tmp_path, "A/frame_0001.png", "A/frame_0002.png", "B/frame_0001.png", "C/c1.png", "C/d1.png", "C/e.png")
    touch(tmp_path, "D/notes.txt", "plate.png")
    found = find_sequences(tmp_path)
    assert [sequence.name for sequence in found.sequences] == ["A", "B", "c", "d"]
    assert sorted(path.name for path in found.left_out) == ["e.png", "plate.png"]


def test_only_stills(tmp_path: Path) -> None:
    touch(tmp_path, "smile.png", "giggle.png")
    assert told(find_sequences(tmp_path)) == [
        ("giggle", [(None, "", "giggle.png")]),
        ("smile", [(None, "", "smile.png")]),
    ]
    found = find_sequences(tmp_path / "smile.png")
    assert told(found) == [("smile", [(None, "", "smile.png")])]
    assert found.sequences[0].gaps == ()


def test_stills_alike_but_for_their_last_word_are_drawings_of_one_character(tmp_path: Path) -> None:
    for name in ("girl smile.png", "girl cry.png", "boy_calm.png", "tree.png"):
        (tmp_path / name).touch()
    found = find_sequences(tmp_path).sequences
    assert [(each.name, [file.path.name for file in each.files]) for each in found] == [
        ("boy_calm", ["boy_calm.png"]),
        ("girl", ["girl cry.png", "girl smile.png"]),
        ("tree", ["tree.png"]),
    ]


def test_a_numbered_file_by_name_is_a_still(tmp_path: Path) -> None:
    touch(tmp_path, "A0001.png", "A0002.png")
    assert told(find_sequences(tmp_path / "A0002.png")) == [("A0002", [(None, "", "A0002.png")])]


def test_pattern_with_letters(tmp_path: Path) -> None:
    touch(tmp_path, "walk_0001.png", "walk_0002a.png", "walk_0002abc.png", "walk_b.png")
    assert told(find_sequences(tmp_path / "walk_#*.png")) == [
        ("walk", [(1, "", "walk_0001.png"), (2, "a", "walk_0002a.png")])
    ]


@pytest.mark.parametrize("pattern", ["walk_#.png", "walk_####.PNG"])
def test_pattern(tmp_path: Path, pattern: str) -> None:
    touch(tmp_path, "walk_0003.png", "walk_0001.png", "walk_0002a.png", "walk_0002.tga", "run_0001.png", "walk_.png")
    assert told(find_sequences(tmp_path / pattern)) == [("walk", [(1, "", "walk_0001.png"), (3, "", "walk_0003.png")])]


def test_pattern_with_letters_and_without_prefix(tmp_path: Path) -> None:
    touch(tmp_path / "A", "1a.png", "2a.png", "2.png")
    assert told(find_sequences(tmp_path / "A" / "#a.png")) == [("A", [(1, "a", "1a.png"), (2, "a", "2a.png")])]


def test_a_folder_may_have_the_sign_in_its_name(tmp_path: Path) -> None:
    touch(tmp_path / "cut#1", "A1.png")
    assert told(find_sequences(tmp_path / "cut#1")) == [("A", [(1, "", "A1.png")])]


def test_gaps(tmp_path: Path) -> None:
    touch(tmp_path, "A3.png", "A4.png", "A7.png", "A9b.png")
    assert find_sequences(tmp_path).sequences[0].gaps == (5, 6, 8)


@pytest.mark.parametrize(
    ("source", "sentence"),
    [
        ("none", "it does not exist"),
        ("empty", "there is no picture in this folder"),
        ("notes.txt", "'.txt' is not a picture format that can be read"),
        ("B_#.png", "no file has such a name"),
        ("none/B_#.png", "its folder does not exist"),
        ("#_#.png", "one run of '#' is needed where the number stands"),
        ("B_#.txt", "'.txt' is not a picture format that can be read"),
        ("a\0b", "it does not exist"),
    ],
)
def test_faults_are_one_sentence(tmp_path: Path, source: str, sentence: str) -> None:
    touch(tmp_path, "notes.txt")
    (tmp_path / "empty").mkdir()
    with pytest.raises(InputProblem) as caught:
        find_sequences(tmp_path / source)
    assert str(caught.value) == f"{tmp_path / source}: {sentence}"


@pytest.mark.parametrize(("second", "counts"), [("001.png", "1.png"), ("1.PNG", "1.PNG")])
def test_one_number_twice_names_both(tmp_path: Path, second: str, counts: str) -> None:
    touch(tmp_path, "1.png", second, "2.png")
    if len(list(tmp_path.iterdir())) < 3:
        pytest.skip("this file system does not tell upper from lower case")
    found = find_sequences(tmp_path)
    assert [file.path.name for file in found.sequences[0].files] == [counts, "2.png"]
    (left,) = {"1.png", second} - {counts}
    assert list(map(str, found.notes)) == [f"of two with one number only one counts: {left} → {counts}"]


@pytest.mark.skipif(os.name == "nt", reason="Windows names are text")
def test_names_that_are_no_text_do_not_stop_it(tmp_path: Path) -> None:
    try:
        (tmp_path / os.fsdecode(b"A\xff1.png")).write_bytes(b"")
    except OSError:
        pytest.skip("this file system takes text alone")
    touch(tmp_path, "A1.png")
    assert len(find_sequences(tmp_path).sequences) == 2
    with pytest.raises(InputProblem, match=r"A\\xff: it does not exist"):
        find_sequences(tmp_path / os.fsdecode(b"A\xff"))


@given(st.lists(st.integers(0, 999_999), unique=True, min_size=1), st.text("aA_- é影", max_size=4))
def test_numbers_order_names(numbers: list[int], prefix: str) -> None:
    names = [f"{prefix}{number}" for number in numbers]
    random.Random(1).shuffle(names)
    assert sorted(names, key=natural_key) == [f"{prefix}{number}" for number in sorted(numbers)]


@given(st.text(), st.text())
def test_the_order_is_total(one: str, other: str) -> None:
    assert (natural_key(one) == natural_key(other)) == (one == other)


def test_real_samples(samples: Path) -> None:
    dance = find_sequences(samples / "animdraw_duo_dance")
    assert [(s.name, len(s.files), s.gaps) for s in dance.sequences] == [("A", 48, ()), ("B", 48, ())]
    kenney = find_sequences(samples / "kenney_male_adventurer")
    assert [(s.name, len(s.files)) for s in kenney.sequences] == [
        ("maleAdventurer_climb", 2),
        ("maleAdventurer_walk", 8),
    ]
    assert len(kenney.left_out) == 3


def test_folders_of_retakes_are_one_character(tmp_path: Path) -> None:
    touch(tmp_path, "A/0001.png", "A/0002.png", "A/0003.png", "A.R1/0002.png", "A.R2/0003.png", "B/0001.png")
    found = find_sequences(tmp_path)
    assert [(each.name, [file.path.parent.name for file in each.files]) for each in found.sequences] == [
        ("A", ["A", "A.R1", "A.R2"]),
        ("B", ["B"]),
    ]
    assert list(map(str, found.notes)) == [
        "taken as one, of which the newest counts: A, A.R1, A.R2; older drawings: 2",
    ]


def test_of_folders_of_versions_the_newest_counts(tmp_path: Path) -> None:
    touch(tmp_path, "walk_v1/0001.png", "walk_v1/0002.png", "walk_v2/0001.png", "run/0001.png")
    found = find_sequences(tmp_path)
    assert [(each.name, [file.path.parent.name for file in each.files]) for each in found.sequences] == [
        ("run", ["run"]),
        ("walk_v2", ["walk_v2"]),
    ]


def test_folders_beside_pictures_are_said(tmp_path: Path) -> None:
    touch(tmp_path, "A0001.png", "A0002.png", "B/0001.png", "notes/readme.txt")
    (note,) = find_sequences(tmp_path).notes
    assert str(note) == "folders beside its pictures are left out: B"


def test_characters_of_one_drawing_each_are_said(tmp_path: Path) -> None:
    touch(tmp_path, "A1.png", "B2.png", "C3.png", "D1.png", "D2.png")
    (note,) = find_sequences(tmp_path).notes
    assert str(note) == "3 characters have one drawing each and are seen together: A, B, C"


def test_a_pattern_says_what_it_does_not_mean(tmp_path: Path) -> None:
    touch(tmp_path, "walk_-0002.png", "walk_0001.png", "walk_0001_R1.png", "walk_0003_x.png", "walk_Ａ.png")
    found = find_sequences(tmp_path / "walk_#*.png")
    assert told(found) == [("walk", [(-2, "", "walk_-0002.png"), (1, "", "walk_0001_R1.png")])]
    assert str(found.notes[-1]) == "not meant by the pattern: walk_0003_x.png"
    assert [file.path.name for file in find_sequences(tmp_path / "walk_#.png").sequences[0].files] == [
        "walk_-0002.png",
        "walk_0001.png",
    ]
    touch(tmp_path / "days", "20260101.png")
    assert told(find_sequences(tmp_path / "days" / "#.png")) == [("days", [(None, "", "20260101.png")])]


def test_chosen_pictures_of_several_folders_are_understood_each_by_its_folder(tmp_path: Path) -> None:
    touch(tmp_path, "A/1.png", "A/2.png", "B/1.png", "B/tree.png")
    chosen = [tmp_path / name for name in ("B/tree.png", "A/2.png", "B/1.png", "A/1.png")]
    assert told(sequences_among(chosen)) == [
        ("A", [(1, "", "1.png"), (2, "", "2.png")]),
        ("B", [(1, "", "1.png")]),
        ("tree", [(None, "", "tree.png")]),
    ]
