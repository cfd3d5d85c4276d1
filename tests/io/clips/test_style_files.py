"""Style files: those of the program, the user's own, and what is no style."""

import json
from collections.abc import Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kagezou.animation.track import Value
from kagezou.document.address import Address
from kagezou.document.edits import add_layer, set_constant
from kagezou.document.local_name import LocalName
from kagezou.document.model import Canvas, Cels, Document
from kagezou.document.property import AnyProperty, Kind
from kagezou.document.style import LINES, SCENE_LINES, Style, style_of
from kagezou.document.styling import put_style
from kagezou.errors import InputProblem, UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.clips.style_files import bundled_styles, load_style, own_styles, save_style
from tests.documents import names, values

GOOD = {"style": 1, "name": {"en": "Mine", "ja": "自分"}, "figure_px": 500, "values": {"shadow.simplify": 30}}


def document() -> Document:
    return add_layer(Document(Canvas(1000, 1000)), "A", Cels(), Box(0, 100, 200, 600))


def another(prop: AnyProperty) -> Value:
    """Return a value that is not the default."""
    match prop.kind:
        case Kind.NUMBER:
            return (prop.low + 3 * prop.high) / 4
        case Kind.CHOICE:
            return prop.choices[0] if prop.default == prop.choices[1] else prop.choices[1]
        case Kind.SWITCH:
            return not prop.default
        case Kind.COLOR:
            return "#12AB34"
        case Kind.PLACE:
            return (1.5, -2.25, 1 / 3)
        case _:
            return (1.5, 1 / 3)


def some(lines: tuple[AnyProperty, ...]) -> st.SearchStrategy[Mapping[str, Value]]:
    """Return strategies for values of some of the lines, none and all of them included."""
    return st.fixed_dictionaries({}, optional={line.name: values(line) for line in lines}).map(MappingProxyType)


@st.composite
def styles(draw: st.DrawFn) -> Style:
    name = LocalName.of(draw(names), **draw(st.fixed_dictionaries({}, optional={"ja": names})))
    return Style(name, draw(st.floats(1, 100_000)), draw(some(LINES)), draw(some(SCENE_LINES)))


class TestBundled:
    def test_all_looks_are_there_in_both_languages(self) -> None:
        names = [each.style.name.en for each in bundled_styles()]
        assert names == ["Natural", "Simple", "Round shadow", "Long evening", "Water", "Torn water", "High key"]
        assert all(each.style.name.in_language("ja") != each.style.name.en for each in bundled_styles())


class TestOwn:
    @settings(deadline=None)
    @given(styles())
    def test_a_style_comes_back_as_it_was(self, style: Style) -> None:
        with TemporaryDirectory() as folder:
            assert load_style(save_style(Path(folder) / "styles", style)) == style

    def test_a_look_with_light_ground_and_set_up_comes_back_on_another_cut(self, tmp_path: Path) -> None:
        lit = document()
        for prop in (*LINES, *SCENE_LINES):
            address = Address(prop, "layer-1" if prop in LINES else None)
            lit = set_constant(lit, address, another(prop))
        kept = style_of(lit, "layer-1", 1, "夜", with_scene=True)
        style = load_style(save_style(tmp_path, kept))
        assert style == kept
        again = put_style(document(), ["layer-1"], style, 1, with_light=True).document
        assert (again.layers, again.tracks) == (lit.layers, lit.tracks)

    def test_a_broken_one_does_not_hide_the_others(self, tmp_path: Path) -> None:
        (tmp_path / "a.json").write_text("{")
        (tmp_path / "b.json").write_text(json.dumps(GOOD))
        found, problems = own_styles(tmp_path)
        assert [each.style.name.in_language("ja") for each in found] == ["自分"]
        assert len(problems) == 1
        assert "a.json" in str(problems[0])
        assert own_styles(tmp_path / "none") == ((), ())

    @pytest.mark.parametrize("name", ["", "   ", "x" * 81, "two\nlines"])
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
        {"values": {"visible": False}},
        {"scene": {"layers": 1}},
        {"scene": {"background.position": [0, 0]}},
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
