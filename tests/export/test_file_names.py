"""How files are called."""

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.document.model import Canvas, Document
from kagezou.document.slate import Slate
from kagezou.errors import UsageProblem
from kagezou.export.file_names import FileNames, Label
from kagezou.export.names import safe_names

LABELS = (Label("Hero", "shadow"), Label("Hero", "contact"), Label("", "composite"))


def document(length: int = 48, first: int = 1, **slate: str) -> Document:
    return Document(Canvas(64, 48, length_frames=length, first_frame=first), slate=Slate(**slate))


def paths(names: FileNames, cut: Document, frame: int = 1, labels: tuple[Label, ...] = LABELS) -> list[str]:
    found = names.named(labels, cut, Path("out"), ".png")
    return [each.file(frame).relative_to("out").as_posix() for each in found]


def test_each_sequence_usually_has_a_folder() -> None:
    assert paths(FileNames(), document(), 7) == [
        "Hero_shadow/Hero_shadow_0007.png",
        "Hero_contact/Hero_contact_0007.png",
        "composite/composite_0007.png",
    ]


@pytest.mark.parametrize(
    ("pattern", "first", "third"),
    [
        ("{layer}_{kind}.{frame:04d}", "Hero_shadow.0007.png", "composite.0007.png"),
        ("{layer}_{kind}.####", "Hero_shadow.0007.png", "composite.0007.png"),
        ("{layer}_{kind}.%06d", "Hero_shadow.000007.png", "composite.000007.png"),
        ("{layer}-{kind}_{frame:3}", "Hero-shadow_007.png", "composite_007.png"),
        ("{frame}_{kind}_{layer}", "0007_shadow_Hero.png", "0007_composite.png"),
        ("{layer}/{kind}/{frame:5d}", "Hero/shadow/00007.png", "composite/00007.png"),
        ("{kind}\\{layer} {frame}", "shadow/Hero 0007.png", "composite/0007.png"),
        (
            "{name}_s{scene}_c{cut}/{layer}.{kind}.{frame}",
            "EP3_s_c12/Hero.shadow.0007.png",
            "EP3_s_c12/composite.0007.png",
        ),
        ("影 {layer}_{kind}{frame}号", "影 Hero_shadow0007号.png", "影_composite0007号.png"),
    ],
)
def test_a_pattern_names_folders_and_files(pattern: str, first: str, third: str) -> None:
    found = paths(FileNames(pattern), document(name="EP3", cut="12"), 7)
    assert (found[0], found[2]) == (first, third)


def test_files_bear_the_numbers_that_the_cut_shows_unless_told_otherwise() -> None:
    cut = document(first=1001)
    assert paths(FileNames("{kind}.{frame}"), cut, 1, LABELS[:1]) == ["shadow.1001.png"]
    assert paths(FileNames("{kind}.{frame}", first=0), cut, 48, LABELS[:1]) == ["shadow.0047.png"]


def test_all_numbers_of_a_cut_are_as_long_as_the_last() -> None:
    assert paths(FileNames("{kind}.{frame:02d}", first=90), document(), 1, LABELS[:1]) == ["shadow.090.png"]
    assert paths(FileNames("{kind}.{frame}", digits=6), document(), 1, LABELS[:1]) == ["shadow.000001.png"]
    assert paths(FileNames("{kind}.{frame}", digits=2), document(), 1, LABELS[:1]) == ["shadow.01.png"]


@pytest.mark.parametrize(
    ("pattern", "said"),
    [
        ("{layer}_{kind}", "needs {frame} once"),
        ("{frame}_{kind}_####", "needs {frame} once"),
        ("{frame}/{kind}", "needs {frame} once"),
        ("{layer}_{shot}.{frame}", "no word '{shot}'"),
        ("{layer}_{}.{frame}", "no word '{}'"),
        ("{layer.{frame}", "a brace has no partner"),
        ("{{layer}}.{frame}", "a brace has no partner"),
        ("{layer!r}.{frame}", "a brace has no partner"),
        ("{layer:>9}.{frame}", "a brace has no partner"),
        ("{kind}.{frame:x}", "a brace has no partner"),
        ("{kind}.{frame:40d}", "1 to 12 digits"),
        ("../{kind}.{frame}", "no place under the output folder"),
        ("/tmp/{kind}.{frame}", "no place under the output folder"),
        ("C:/{kind}.{frame}", "no place under the output folder"),
        ("{kind}//{frame}", "no place under the output folder"),
        ("{kind}\n.{frame}", "no place under the output folder"),
        ("{kind}?.{frame}", "no place under the output folder"),
        ("", "no place under the output folder"),
    ],
)
def test_what_cannot_name_files_is_refused(pattern: str, said: str) -> None:
    with pytest.raises(UsageProblem) as caught:
        FileNames(pattern)
    assert said in str(caught.value)


def test_numbers_out_of_range_and_digits_said_twice_are_refused() -> None:
    for first in (-1, 1_000_000):
        with pytest.raises(UsageProblem, match="numbered from 0 to 999999"):
            FileNames(first=first)
    for digits in (0, 13):
        with pytest.raises(UsageProblem, match="1 to 12 digits"):
            FileNames(digits=digits)
    with pytest.raises(UsageProblem, match="said twice"):
        FileNames("{kind}.####", digits=5)


@pytest.mark.parametrize("pattern", ["{layer}.{frame}", "{kind}.{frame}", "all.{frame}"])
def test_a_pattern_that_mixes_sequences_is_refused(pattern: str) -> None:
    labels = (Label("Hero", "shadow"), Label("hero", "Shadow"), Label("Hero", "contact"))
    with pytest.raises(UsageProblem, match="would have the same files"):
        paths(FileNames(pattern), document(), labels=labels)


@given(names=st.lists(st.text(max_size=30).filter(bool), min_size=1, max_size=4, unique=True), frame=st.integers(1, 48))
def test_any_layers_have_files_of_their_own_in_one_folder(names: list[str], frame: int) -> None:
    labels = tuple(Label(each, kind) for each in safe_names(names).values() for kind in ("shadow", "contact"))
    found = paths(FileNames("{layer}_{kind}.{frame}"), document(), frame, labels)
    assert len({each.casefold() for each in found}) == len(labels)
    assert all("/" not in each and each.endswith(f".{frame:04d}.png") for each in found)


def test_an_empty_word_takes_one_joint_along() -> None:
    cut = replace(document(), slate=Slate())
    found = paths(FileNames("{cut}_{layer}_{kind}.{frame}"), cut)
    assert found[0] == "Hero_shadow.0001.png"
