"""What is said to receive shadows while none can fall on it."""

from dataclasses import replace

import pytest

from kagezou.document.address import resolve
from kagezou.document.edits import set_constant, set_key
from kagezou.document.model import Document
from kagezou.scene.idle_receivers import idle_receivers
from kagezou.scene.misfits import MisfitKind, misfits_of
from tests.tools.tool_scenes import document_with, with_piece


def valued(document: Document, **values: object) -> Document:
    for path, value in values.items():
        document = set_constant(document, resolve(document, path), value)
    return document


def two(document: Document) -> Document:
    first = document.layers[0]
    return replace(document, layers=(first, replace(first, id="other", name="B")))


def said(document: Document) -> list[str]:
    return [str(words) for _, words in idle_receivers(document)]


def test_a_character_alone_receives_nothing() -> None:
    assert said(document_with()) == []
    (words,) = said(valued(document_with(), **{"layers.A.receives": True}))
    assert words.startswith("A: receives is on, but there is no other character")


@pytest.mark.parametrize(
    ("values", "count"),
    [
        ({}, 0),
        ({"layers.B.visible": False}, 1),
        ({"layers.B.shadow.shape": "disc"}, 1),
        ({"layers.A.receives": False}, 0),
    ],
)
def test_another_character_must_cast_at_some_time(values: dict[str, object], count: int) -> None:
    document = valued(two(document_with()), **{"layers.A.receives": True, **values})
    assert len(said(document)) == count


def test_keys_count_on_any_frame() -> None:
    document = valued(two(document_with()), **{"layers.A.receives": True})
    at = resolve(document, "layers.B.visible")
    hidden = set_key(document, at, 1, False)  # noqa: FBT003 - a value of a property
    assert len(said(hidden)) == 1
    assert said(set_key(hidden, at, 9, True)) == []  # noqa: FBT003 - a value of a property


def test_a_part_of_the_same_figure_is_no_other() -> None:
    document = two(document_with())
    first, other = document.layers
    joined = replace(document, layers=(first, replace(other, joins=first.id)))
    assert len(said(valued(joined, **{"layers.B.receives": True}))) == 1


def test_shadows_need_a_receiver() -> None:
    document = valued(document_with(), **{"ground.receives": False})
    assert said(document) == ["no shadow is seen: ground.receives is off, and no set piece receives"]
    walled = with_piece(document, "wall", position=[500, 700])
    assert said(walled) == []
    name = walled.pieces[0].name
    assert len(said(valued(walled, **{f"set.{name}.receives": False}))) == 1


def test_it_is_among_the_misfits() -> None:
    document = valued(document_with(), **{"layers.A.receives": True})
    assert [each.kind for each in misfits_of(document)].count(MisfitKind.IDLE) == 1
