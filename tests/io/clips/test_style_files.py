"""Style files: those of the program, the user's own, and what is no style."""

import json
from pathlib import Path
from types import MappingProxyType

import pytest

from kagezou.document.address import Address, value_of
from kagezou.document.edits import add_layer, set_key
from kagezou.document.local_name import LocalName
from kagezou.document.model import Canvas, Cels, Document
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.document.style import LINES, Style, apply_style, style_of
from kagezou.errors import InputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.clips.style_files import bundled_styles, load_style, own_styles, save_style

GOOD = {"style": 1, "name": {"en": "Mine", "ja": "自分"}, "figure_px": 500, "values": {"shadow.simplify": 30}}


def document(height: int = 500) -> Document:
    return add_layer(Document(Canvas(1000, 1000)), "A", Cels(), Box(0, 100, 200, 100 + height))


def value(of: Document, name: str, frame: int = 1) -> object:
    address = Address(OF_LAYER[name], "layer-1") if name in OF_LAYER else Address(OF_DOCUMENT[name])
    return value_of(of, address, frame)


class TestBundled:
    def test_all_looks_are_there_in_both_languages(self) -> None:
        names = [each.style.name.en for each in bundled_styles()]
        assert names == ["Natural", "Simple", "Round shadow", "Long evening", "Water", "Torn water", "High key"]
        assert all(each.style.name.in_language("ja") != each.style.name.en for each in bundled_styles())

    def test_each_replaces_the_one_before_wholly(self) -> None:
        """What one style sets the next sets too, so that nothing of the first is left."""
        names = [set(each.style.values) for each in bundled_styles()]
        waves = {name for name in OF_LAYER if name.startswith(("shadow.wave", "shadow.slit_"))}
        assert len({frozenset(each - waves) for each in names}) == 1
        assert all("shadow.wave1.amplitude" in each for each in names)


class TestApplying:
    def test_lengths_grow_with_the_character(self) -> None:
        style = Style(LocalName("a"), 500.0, MappingProxyType({"shadow.simplify": 30.0, "shadow.opacity": 0.4}))
        tall = apply_style(document(1000), "layer-1", style, 1)
        assert (value(tall, "shadow.simplify"), value(tall, "shadow.opacity")) == (60.0, 0.4)
        huge = apply_style(document(100_000), "layer-1", style, 1)
        assert value(huge, "shadow.simplify") == 500.0

    def test_areas_grow_with_it_twice(self) -> None:
        style = Style(LocalName("a"), 500.0, MappingProxyType({"shadow.least_part": 30.0}))
        assert value(apply_style(document(1000), "layer-1", style, 1), "shadow.least_part") == 120.0

    def test_what_is_keyed_gets_a_key(self) -> None:
        keyed = set_key(document(), Address(OF_LAYER["shadow.simplify"], "layer-1"), 1, 5.0)
        style = Style(LocalName("a"), 500.0, MappingProxyType({"shadow.simplify": 30.0}))
        after = apply_style(keyed, "layer-1", style, 9)
        assert [value(after, "shadow.simplify", frame) for frame in (1, 5, 9)] == [5.0, 17.5, 30.0]

    def test_a_style_may_bring_its_light(self) -> None:
        style = next(each.style for each in bundled_styles() if each.style.scene)
        assert value(apply_style(document(), "layer-1", style, 1), "light.kind") == "sun"


class TestOwn:
    def test_a_look_is_kept_and_comes_back(self, tmp_path: Path) -> None:
        style = bundled_styles()[4].style
        before = apply_style(document(), "layer-1", style, 1)
        kept = style_of(before, "layer-1", 1, "水たまり")
        path = save_style(tmp_path / "styles", kept)
        assert load_style(path) == kept
        again = apply_style(document(), "layer-1", load_style(path), 1)
        assert all(value(again, line.name) == value(before, line.name) for line in LINES)

    def test_a_broken_one_does_not_hide_the_others(self, tmp_path: Path) -> None:
        (tmp_path / "a.json").write_text("{")
        (tmp_path / "b.json").write_text(json.dumps(GOOD))
        found, problems = own_styles(tmp_path)
        assert [each.style.name.in_language("ja") for each in found] == ["自分"]
        assert len(problems) == 1
        assert "a.json" in str(problems[0])
        assert own_styles(tmp_path / "none") == ((), ())

    @pytest.mark.parametrize("name", ["", "   ", "x" * 81])
    def test_not_every_name_is_one(self, tmp_path: Path, name: str) -> None:
        with pytest.raises(UsageProblem):
            save_style(tmp_path, Style(LocalName(name), 500.0, MappingProxyType({})))

    def test_a_name_stays_in_its_folder(self, tmp_path: Path) -> None:
        path = save_style(tmp_path / "styles", Style(LocalName("../x/y"), 500.0, MappingProxyType({})))
        assert path.parent == tmp_path / "styles"


@pytest.mark.parametrize(
    "change",
    [
        {"style": 2},
        {"figure_px": 0},
        {"figure_px": True},
        {"figure_px": "tall"},
        {"name": "Mine"},
        {"name": {"en": "", "ja": "x"}},
        {"values": {"shadow.simplify": -1}},
        {"values": {"shadow.wave_seed": 1}},
        {"values": {"tilt.x": 1}},
        {"scene": {"layers": 1}},
        {"more": 1},
    ],
)
def test_what_is_no_style_is_one_sentence(tmp_path: Path, change: dict[str, object]) -> None:
    path = tmp_path / "bad.json"
    path.write_text(json.dumps({**GOOD, **change}))
    with pytest.raises(InputProblem, match=r"bad\.json.* is not a style: "):
        load_style(path)


def test_what_cannot_be_read_is_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "binary.json").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "large.json").write_bytes(b" " * (1 << 21))
    for name in ("binary.json", "large.json", "none.json"):
        with pytest.raises(InputProblem, match=name.replace(".", r"\.")):
            load_style(tmp_path / name)
