"""Whatever a step makes can be saved and loads again, or the step is refused with a sentence."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given

from kagezou.animation.ease import Ease
from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document import properties
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer, Marker, Piece, Tracks
from kagezou.document.note import Note
from kagezou.errors import ProjectProblem
from kagezou.geometry.box import Box
from kagezou.io.files.json_text import parse
from kagezou.io.project import savable
from kagezou.io.project.file import dumps, loads
from kagezou.io.project.savable import Savable, Weight, weight_of
from kagezou.session.session import Session
from tests.documents import documents

OPACITY = properties.OPACITY.name
LAYER = Layer("a", "A", Cels((Drawing("1", Path("/cels/1.png")),), (Exposure(1, 0),)), Box(0, 0, 10, 20))
DOCUMENT = Document(Canvas(64, 48, length_frames=24), layers=(LAYER,))


def keyed(*keys: Key) -> Tracks:
    return {OPACITY: Track(0.5, keys)}


def with_layer(**changes: Any) -> Document:
    return replace(DOCUMENT, layers=(replace(LAYER, **changes),))


REFUSED: dict[str, tuple[Callable[[], Document], str]] = {
    "a name too long": (lambda: with_layer(name="n" * 201), "is not a text of 1 to 200 characters"),
    "a name that cannot be read": (lambda: with_layer(name="a\nb"), "is not a printable name"),
    "a name twice": (lambda: replace(DOCUMENT, layers=(LAYER, replace(LAYER, id="b"))), "same name"),
    "an empty figure": (lambda: with_layer(figure=Box(3, 3, 3, 9)), "is not a box with pixels in it"),
    "a key beyond the last frame": (
        lambda: with_layer(tracks=keyed(Key(1_000_001, 0.5))),
        "1000001 is not a whole number",
    ),
    "a value beyond its range": (lambda: with_layer(tracks=keyed(Key(1, 1e30))), "keys[0].value"),
    "a speed beyond all range": (
        lambda: with_layer(tracks=keyed(Key(1, 0.5, Interpolation.BEZIER, ease_out=(Ease(1e13, 0.3),)))),
        "is not a number from -1e+12 to 1e+12",
    ),
    "an exposure beyond the last frame": (
        lambda: with_layer(cels=replace(LAYER.cels, exposures=(Exposure(1, 0), Exposure(1_000_001, None)))),
        "exposures[1][0]",
    ),
    "a drawing without a name": (
        lambda: with_layer(cels=replace(LAYER.cels, drawings=(Drawing("", Path("/cels/1.png")),))),
        "is not a text of 1 to 4096 characters",
    ),
    "a marker that says too much": (lambda: replace(DOCUMENT, markers=(Marker(1, "m" * 4001),)), "markers[0]"),
    "a note that says too much": (lambda: replace(DOCUMENT, notes=(Note(1, OPACITY, "n" * 4001, "a"),)), "notes[0]"),
    "a sheet that says too much": (lambda: replace(DOCUMENT, timesheet="x" * ((1 << 20) + 1)), "timesheet"),
    "a piece with a name too long": (
        lambda: replace(DOCUMENT, pieces=(Piece("p", "n" * 201),)),
        "is not a text of 1 to 200 characters",
    ),
    "too many pieces": (
        lambda: replace(DOCUMENT, pieces=tuple(Piece(f"{n}", f"{n}") for n in range(201))),
        "a set has at most 200 pieces",
    ),
    "too many layers": (
        lambda: replace(DOCUMENT, layers=tuple(replace(LAYER, id=f"{n}", name=f"{n}") for n in range(1001))),
        "more than 1000 layers",
    ),
    "too long a cut": (lambda: replace(DOCUMENT, canvas=Canvas(64, 48, length_frames=1_000_001)), "1000001 frames"),
    "too large a canvas": (lambda: replace(DOCUMENT, canvas=Canvas(20_000, 48)), "20000x48"),
    "too fast a cut": (lambda: replace(DOCUMENT, canvas=Canvas(64, 48, Fraction(2000))), "2000"),
    "a frame rate no text holds": (
        lambda: replace(DOCUMENT, canvas=Canvas(64, 48, Fraction(10**19 + 1, 10**18))),
        "frame_rate",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_could_not_be_saved_is_refused_in_one_sentence(name: str) -> None:
    make, said = REFUSED[name]
    after = make()
    with pytest.raises(ProjectProblem) as by_saving:
        loads(dumps(after, Path("/cuts")), Path("/cuts"))
    with pytest.raises(ProjectProblem, match="this was not done") as caught:
        Savable(DOCUMENT).admit(DOCUMENT, after)
    assert said in str(caught.value), by_saving.value
    assert "\n" not in str(caught.value)


@given(documents(), documents())
def test_what_can_be_saved_is_admitted(before: Document, after: Document) -> None:
    Savable(before).admit(before, after)


def test_only_what_was_added_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    texts: list[str] = []

    def listening(text: str) -> object:
        texts.append(text)
        return parse(text)

    monkeypatch.setattr(savable, "parse", listening)
    keys = tuple(Key(frame, 0.5) for frame in range(1, 1001))
    before = with_layer(tracks=keyed(*keys))
    after = replace(
        before, layers=(replace(before.layers[0], tracks=keyed(*keys, Key(1001, 0.25))),), markers=(Marker(3, "hop"),)
    )
    Savable(before).admit(before, after)
    (text,) = texts
    assert text.count('"frame"') == 1
    assert "hop" in text
    assert "/cels" not in text


class TestWeight:
    @pytest.fixture(autouse=True)
    def _small(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(savable, "MAX_BYTES", weight_of(DOCUMENT).size + 10_000)

    def longer(self, document: Document, characters: int) -> Document:
        return replace(document, timesheet="x" * characters)

    def test_more_than_a_project_holds_is_refused(self) -> None:
        guard = Savable(DOCUMENT)
        with pytest.raises(ProjectProblem, match="a project holds at most"):
            guard.admit(DOCUMENT, self.longer(DOCUMENT, 10_100))
        guard.admit(DOCUMENT, self.longer(DOCUMENT, 9_000))

    def test_more_values_than_a_project_holds_are_refused(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(savable, "MOST_VALUES", weight_of(DOCUMENT).values + 100)
        with pytest.raises(ProjectProblem, match="a project holds at most"):
            Savable(DOCUMENT).admit(DOCUMENT, replace(DOCUMENT, timesheet="," * 101))

    def test_it_is_summed_up_over_steps_and_measured_before_it_is_refused(self) -> None:
        guard, document = Savable(DOCUMENT), DOCUMENT
        for _ in range(10):
            after = self.longer(document, 6_000)
            guard.admit(document, after)
            document = after

    def test_what_undo_brings_back_counts(self) -> None:
        guard = Savable(DOCUMENT)
        first = self.longer(DOCUMENT, 9_000)
        emptied = self.longer(first, 0)
        guard.admit(DOCUMENT, first)
        guard.admit(first, emptied)
        guard.admit(emptied, self.longer(emptied, 2))
        marked = replace(first, markers=(Marker(1, "m" * 3000),))
        with pytest.raises(ProjectProblem, match="a project holds at most"):
            guard.admit(first, marked)

    def test_weights_add_up(self) -> None:
        assert Weight(1, 2) + Weight(3, 4) == Weight(4, 6)


def test_a_refused_step_leaves_everything_as_it_was() -> None:
    session = Session(DOCUMENT, Savable(DOCUMENT).admit)
    with pytest.raises(ProjectProblem):
        session.edit("Rename", REFUSED["a name too long"][0]())
    assert session.document is DOCUMENT
    assert session.undo_name is None
    gesture = session.begin("Drag")
    gesture.show(REFUSED["a key beyond the last frame"][0]())
    with pytest.raises(ProjectProblem):
        gesture.commit()
    assert session.document is DOCUMENT
    assert not session.is_in_gesture
    session.edit("Mark", replace(DOCUMENT, markers=(Marker(1, "here"),)))
    assert session.undo_name == "Mark"
