"""Settings of the whole cut: one edit, and what is said of it before."""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from kagezou.document.address import Address
from kagezou.document.cut_settings import CutSettings, with_settings
from kagezou.document.cut_words import CUT_WORDS, cut_word_at
from kagezou.document.edits import add_layer, set_background, set_constant, set_key
from kagezou.document.linking import link
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Marker
from kagezou.document.properties import FOV, LIGHT_AZIMUTH, OPACITY, SIMPLIFY
from kagezou.document.refitting import Refit
from kagezou.document.slate import Slate
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box


def cut() -> Document:
    cels = Cels((Drawing("1", Path("/a.png")), Drawing("2", Path("/b.png"))), (Exposure(1, 0), Exposure(20, 1)))
    document = Document(Canvas(200, 100, length_frames=24))
    for name in ("A", "B"):
        document = add_layer(document, name, cels, Box(60, 20, 90, 80))
    return document


def said(document: Document, refit: Refit = Refit.CENTRE, slate: Slate | None = None, **canvas: Any) -> list[str]:
    settings = CutSettings(replace(document.canvas, **canvas), slate or document.slate)
    return [str(note) for note in with_settings(document, settings, refit).notes]


def test_what_is_as_it_was_is_the_same_document() -> None:
    document = cut()
    changed = with_settings(document, CutSettings.of(document), Refit.SCALE)
    assert changed.document is document
    assert not changed.notes


def test_everything_changes_at_once() -> None:
    document = cut()
    wanted = CutSettings(Canvas(400, 200, Fraction(24000, 1001), 12, 101), Slate(" ep3 ", "2", "12A"))
    changed = with_settings(document, wanted, Refit.STAY).document
    assert changed.canvas == wanted.canvas
    assert changed.slate == Slate("ep3", "2", "12A")
    assert changed.slate.label == "ep3_s2_c12A"
    assert Slate().label == ""


def test_what_lies_behind_a_new_end_is_counted_and_kept() -> None:
    document = replace(cut(), markers=(Marker(5), Marker(24, "end")))
    for frame in (3, 18, 24):
        document = set_key(document, Address(LIGHT_AZIMUTH), frame, 5)
    assert said(document, length_frames=12) == [
        "keys behind the new end, kept and not reached: 2",
        "drawings exposed behind the new end, kept and not seen: 2",
        "markers and notes behind the new end: 1",
    ]
    assert said(document, length_frames=36) == []
    shorter = with_settings(document, CutSettings(replace(document.canvas, length_frames=12), Slate()), Refit.STAY)
    assert shorter.document.tracks is document.tracks


def test_the_keys_of_a_linked_property_count_once() -> None:
    address = Address(OPACITY, "layer-1")
    document = link(set_key(set_key(cut(), address, 1, 0.5), address, 20, 0.2), address)
    assert said(document, length_frames=15)[0].endswith("reached: 1")


def test_another_rate_says_how_long_the_cut_lasts_then() -> None:
    assert said(cut(), frame_rate=Fraction(12)) == [
        "at 12 frames a second the cut lasts 2.00 instead of 1.00 s; keys and drawings stay on their frames"
    ]


def test_another_first_frame_says_where_it_is_not_shown() -> None:
    assert len(said(cut(), first_frame=101)) == 1
    document = replace(cut(), canvas=replace(cut().canvas, first_frame=101))
    assert said(document, first_frame=1) == []


def test_another_size_says_what_it_does() -> None:
    document = set_background(cut(), Path("/bg.png"))
    size: dict[str, Any] = {"width_px": 400, "height_px": 300}
    assert said(document, Refit.SCALE, **size) == [
        "drawings and all lengths become 200 % of what they were",
        "the sides have another proportion: what was the picture is now the middle 400 × 200 px",
        "the picture of the background keeps its own size in px",
    ]
    assert said(document, Refit.CENTRE, **size) == ["the picture of the background keeps its own size in px"]
    assert said(cut(), Refit.CENTRE, **size) == []
    assert said(cut(), Refit.STAY, width_px=100) == ["what lies beyond the smaller picture is kept and not seen"]
    assert said(Document(Canvas(200, 100)), Refit.SCALE, **size) == []
    far = set_constant(set_constant(cut(), Address(FOV), 30), Address(SIMPLIFY, "layer-1"), 400)
    assert said(far, Refit.SCALE, width_px=400, height_px=200)[-1].endswith("kept at its end: 1")
    assert "perspective" in said(far, Refit.STAY, **size)[-1]


@pytest.mark.parametrize(
    "canvas", [{"width_px": 0}, {"height_px": 16385}, {"length_frames": 0}, {"first_frame": -1}, {"frame_rate": 1001}]
)
def test_what_no_cut_can_have_is_refused(canvas: dict[str, Any]) -> None:
    with pytest.raises(UsageProblem, match="canvas"):
        said(cut(), **canvas)


@pytest.mark.parametrize("word", ["x" * 61, "a\nb"])
def test_what_cannot_stand_on_a_slate_is_refused(word: str) -> None:
    with pytest.raises(UsageProblem, match="slate"):
        said(cut(), slate=Slate(cut=word))


def test_every_word_leads_back_to_what_it_says() -> None:
    document = replace(cut(), canvas=Canvas(301, 77, Fraction(24000, 1001), 9, 0), slate=Slate("a name", "3B", "012"))
    plain = CutSettings.of(Document(Canvas(1920, 1080)))
    for word in CUT_WORDS:
        assert cut_word_at(word.path) is word
        assert word.value(plain) == word.usual
        plain = word.said(plain, word.value(CutSettings.of(document)))
    assert plain == CutSettings.of(document)
    assert cut_word_at("canvas.colour") is None


@pytest.mark.parametrize(
    ("path", "word", "value"),
    [
        ("canvas.size", [640, 480], "640x480"),
        ("canvas.size", "640 × 480", "640x480"),
        ("canvas.fps", 12.5, "25/2"),
        ("canvas.fps", 29.97, "30000/1001"),
        ("canvas.cut", 12, "12"),
    ],
)
def test_words_are_taken_as_people_and_json_say_them(path: str, word: object, value: str) -> None:
    found = cut_word_at(path)
    assert found is not None
    assert found.value(found.said(CutSettings.of(cut()), word)) == value


@pytest.mark.parametrize(
    ("path", "word"),
    [
        ("canvas.size", "large"), ("canvas.size", [1, 2, 3]), ("canvas.fps", True),
        ("canvas.length", "2+00"), ("canvas.length", -3), ("canvas.first_frame", 1.5), ("canvas.name", None),
    ],
)  # fmt: skip
def test_words_that_mean_nothing_are_refused(path: str, word: object) -> None:
    found = cut_word_at(path)
    assert found is not None
    with pytest.raises(UsageProblem):
        found.said(CutSettings.of(cut()), word)
