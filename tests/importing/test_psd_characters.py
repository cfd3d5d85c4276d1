"""What groups and layers of a PSD file become."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.importing.psd_characters import PsdCharacters, characters_in
from kagezou.io.psd.tree import PsdNode, PsdTree, addressed


def leaf(name: str, *, hidden: bool = False, empty: bool = False, clipped: bool = False) -> PsdNode:
    return PsdNode(name, name, not hidden, None, clipped, empty)


def group(name: str, *children: PsdNode, hidden: bool = False) -> PsdNode:
    return PsdNode(name, name, not hidden, children)


def cels(first: int, last: int, shown: int = 1, prefix: str = "") -> tuple[PsdNode, ...]:
    return tuple(leaf(f"{prefix}{number}", hidden=number != shown) for number in range(first, last + 1))


def cast(*layers: PsdNode) -> PsdCharacters:
    return characters_in(PsdTree(64, 48, layers), "file")


def shape(found: PsdCharacters) -> list[tuple[str, list[str]]]:
    return [(each.name, [cel.node.name for cel in each.cels]) for each in found.characters]


def test_a_group_of_numbered_layers_is_a_character_with_its_hidden_cels() -> None:
    found = cast(group("B", *cels(1, 3, shown=2)), group("A", *cels(1, 2)))
    assert shape(found) == [("B", ["1", "2", "3"]), ("A", ["1", "2"])]
    assert not found.hidden


@pytest.mark.parametrize(
    ("names", "ordered", "called"),
    [
        (["10", "2", "1"], ["1", "2", "10"], ["1", "2", "10"]),
        (["A_0003", "A_0001"], ["A_0001", "A_0003"], ["1", "3"]),
        (["1a", "1", "2"], ["1", "1a", "2"], ["1", "1a", "2"]),
        (["A1", "A2", "A1b"], ["A1", "A1b", "A2"], ["1", "1b", "2"]),
        (["１", "２"], ["１", "２"], ["1", "2"]),
        (["キャラ-01", "キャラ-02"], ["キャラ-01", "キャラ-02"], ["1", "2"]),
        (["1", "1", "2"], ["1", "1", "2"], ["1", "1", "2"]),
    ],
)
def test_numbers_in_names(names: list[str], ordered: list[str], called: list[str]) -> None:
    found = cast(group("キャラ", *map(leaf, names)))
    assert shape(found) == [("キャラ", ordered)]
    assert [cel.name for cel in found.characters[0].cels] == called


def test_numbered_layers_beside_the_groups_are_called_like_the_file() -> None:
    found = cast(leaf("2"), leaf("1", hidden=True), group("hat", leaf("brim")))
    assert shape(found) == [("file", ["1", "2"]), ("hat", ["hat"])]


def test_two_runs_of_numbers_beside_each_other_are_two_characters() -> None:
    assert shape(cast(*cels(1, 2, prefix="A"), *cels(1, 2, prefix="B"))) == [("a", ["A1", "A2"]), ("b", ["B1", "B2"])]


def test_the_parts_of_a_figure_are_one_drawing() -> None:
    found = cast(group("Hero", leaf("arm1"), leaf("arm2"), leaf("body")), leaf("Prop"))
    assert shape(found) == [("Hero", ["Hero"]), ("Prop", ["Prop"])]


def test_layers_that_nobody_named_are_parts_when_seen_together_and_cels_when_not() -> None:
    together = [leaf("Layer 1"), leaf("Layer 2"), leaf("Layer 3")]
    alone = [leaf("レイヤー 1"), leaf("レイヤー 2", hidden=True)]
    assert shape(cast(group("Hero", *together))) == [("Hero", ["Hero"])]
    assert shape(cast(group("Hero", *alone))) == [("Hero", ["レイヤー 1", "レイヤー 2"])]


def test_cels_may_be_groups_of_line_and_paint() -> None:
    one = group("1", leaf("Layer 1"), leaf("Layer 2"))
    two = group("2", leaf("Layer 1"), leaf("Layer 2"), hidden=True)
    assert shape(cast(group("A", one, two))) == [("A", ["1", "2"])]


def test_a_group_of_named_cels_is_one_figure() -> None:
    hero = group("Hero", group("body", *cels(1, 2)), group("arm", *cels(1, 3)), leaf("hat"))
    assert [(each.name, each.joins) for each in cast(hero).characters] == [
        ("Hero body", None),
        ("Hero arm", "Hero body"),
        ("Hero hat", "Hero body"),
    ]
    columns = group("Hero", group("A", *cels(1, 2)), group("b", *cels(1, 2)))
    for apart in (group("characters", *hero.children or ()), columns):
        assert all(each.joins is None for each in cast(apart).characters)


def test_folders_are_searched() -> None:
    inner = group("CELS", group("A", *cels(1, 2)), group("B", *cels(1, 3)))
    assert shape(cast(group("cut1", inner, leaf("fx")))) == [("A", ["1", "2"]), ("B", ["1", "2", "3"]), ("fx", ["fx"])]


def test_what_stands_beside_the_cels_of_a_group_does_not_disturb_them() -> None:
    assert shape(cast(group("A", leaf("frame"), *cels(1, 2)))) == [("A", ["1", "2"])]
    assert shape(cast(group("A", leaf("frame"), *cels(1, 2, prefix="A")))) == [("A", ["A1", "A2"])]
    assert shape(cast(group("A", leaf("rough", hidden=True), *cels(1, 2, prefix="x")))) == [("A", ["x1", "x2"])]


def test_clipping_layers_belong_to_what_is_below_them() -> None:
    found = cast(leaf("Hero"), leaf("shade", clipped=True), group("A", leaf("1"), leaf("2", clipped=True)))
    assert shape(found) == [("Hero", ["Hero"]), ("A", ["1"])]


@pytest.mark.parametrize("name", ["BG", "bg_01", "背景", "LO", "Background", "ＢＧ", "背景 2", "用紙", "レイアウト"])
def test_layers_named_like_a_background(name: str) -> None:
    found = cast(leaf(name), leaf("Hero"))
    assert [node.name for node in found.backgrounds] == [name]
    assert shape(found) == [("Hero", ["Hero"])]


@pytest.mark.parametrize("name", ["bgirl", "Lola", "backgrounder", "LOX"])
def test_layers_not_named_like_a_background(name: str) -> None:
    assert not cast(leaf(name)).backgrounds


def test_hidden_and_empty_layers_are_left_out() -> None:
    found = cast(
        leaf("rough", hidden=True),
        leaf("nothing", empty=True),
        group("G", leaf("x", hidden=True)),
        leaf("BG", hidden=True),
    )
    assert shape(found) == []
    assert [node.name for node in found.hidden] == ["rough", "BG"]
    assert [node.name for node in found.empty] == ["nothing", "G"]


_NAMES = st.sampled_from(["1", "2", "A1", "A_02", "1a", "Layer 1", "BG", "背景", "Hero", "", "x"])


def _placed(nodes: list[PsdNode], parent: str | None = None) -> tuple[PsdNode, ...]:
    found = addressed([node.name for node in nodes], parent)
    return tuple(
        PsdNode(
            each.name,
            address,
            each.is_visible,
            None if each.children is None else _placed(list(each.children), address),
            each.is_clipped,
            each.is_empty,
        )
        for each, address in zip(nodes, found, strict=True)
    )


_LEAVES = st.builds(
    lambda name, hidden, empty, clipped: leaf(name, hidden=hidden, empty=empty, clipped=clipped),
    _NAMES,
    st.booleans(),
    st.booleans(),
    st.booleans(),
)
_TREES = st.lists(
    st.recursive(
        _LEAVES,
        lambda inner: st.builds(
            lambda name, children, hidden: group(name, *children, hidden=hidden),
            _NAMES,
            st.lists(inner, max_size=4),
            st.booleans(),
        ),
        max_leaves=12,
    ),
    max_size=4,
).map(_placed)


def test_what_lies_in_a_group_without_a_name_is_not_what_lies_beside_it() -> None:
    layers = _placed([leaf("1"), group("", leaf("1"), leaf("2")), group("", leaf("1"))])
    addresses = [node.address for top in layers for node in (top, *top.below())]
    assert len(set(addresses)) == len(addresses) == 6


@given(_TREES)
def test_nothing_is_taken_twice_and_every_cel_is_in_the_file(layers: tuple[PsdNode, ...]) -> None:
    found = cast(*layers)
    everything = {node.address for top in layers for node in (top, *top.below())}
    taken = [cel.node.address for each in found.characters for cel in each.cels]
    taken += [node.address for node in (*found.backgrounds, *found.hidden, *found.empty)]
    assert len(taken) == len(set(taken))
    assert set(taken) <= everything
    for one in taken:
        assert not any(other.startswith(f"{one}/") for other in taken)
    for character in found.characters:
        assert character.cels


@pytest.mark.parametrize(
    ("names", "ordered", "called"),
    [
        (["A_0001_col", "A_0002_col"], ["A_0001_col", "A_0002_col"], ["1", "2"]),
        (["c012_A_1", "c012_A_2"], ["c012_A_1", "c012_A_2"], ["1", "2"]),
        (["A (2)", "A (1)"], ["A (1)", "A (2)"], ["1", "2"]),
        (["00000002", "00000001"], ["00000001", "00000002"], ["1", "2"]),
        (["-1", "0", "-2"], ["-2", "-1", "0"], ["-2", "-1", "0"]),
        (["Ａ１", "a2"], ["Ａ１", "a2"], ["1", "2"]),
        (["1_v2", "2_v2"], ["1_v2", "2_v2"], ["1", "2"]),
    ],
)
def test_numbers_are_found_as_in_names_of_files(names: list[str], ordered: list[str], called: list[str]) -> None:
    found = cast(group("A", *map(leaf, names)))
    assert shape(found) == [("A", ordered)]
    assert [cel.name for cel in found.characters[0].cels] == called


@pytest.mark.parametrize("newer", ["2_R1", "2r2", "2_retake1", "2_v3", "2 リテイク"])
def test_of_retakes_the_newest_counts_and_is_said(newer: str) -> None:
    found = cast(group("A", leaf("1"), leaf("2", hidden=True), leaf(newer, hidden=True)))
    assert shape(found) == [("A", ["1", newer])]
    assert list(map(str, found.notes)) == ["A: newer retakes count instead of 2"]


def test_older_versions_of_all_cels_are_left_out_and_said() -> None:
    found = cast(group("A", *(leaf(name) for name in ("v1_1", "v1_2", "v2_1", "v2_2"))))
    assert shape(found) == [("A", ["v2_1", "v2_2"])]
    assert list(map(str, found.notes)) == ["A: newer retakes count instead of v1_1, v1_2"]


def test_copies_of_layers_are_no_cels() -> None:
    found = cast(group("A", leaf("1"), leaf("1 copy"), leaf("2", hidden=True)))
    assert shape(found) == [("A", ["1", "2"])]
    assert [node.name for node in found.unnumbered] == ["1 copy"]
