"""Which shadows of a frame unite."""

from pathlib import Path

from kagezou.document import edits
from kagezou.document.address import resolve
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.geometry.box import Box
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Fade, ShadowLook
from kagezou.scene.uniting import shadow_groups, united_look

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0), Exposure(9, None)))


def cut(**values: object) -> Document:
    """Return a cut of A, B and C; keywords are paths below ``layers`` with ``__`` for dots."""
    document = Document(Canvas(400, 300))
    for name in "ABC":
        document = edits.add_layer(document, name, CELS, Box(100, 50, 200, 250))
    for key, value in values.items():
        path = f"layers.{key.replace('__', '.')}"
        document = edits.set_constant(document, resolve(document, path), value)
    return document


def names(document: Document, frame: int = 1) -> list[str]:
    return ["".join(layer.name for layer in group) for group in shadow_groups(evaluate(document, frame))]


def test_shadows_of_one_look_are_a_group_in_the_place_of_the_lowest() -> None:
    assert names(cut()) == ["ABC"]
    assert names(cut(B__shadow__color="#FF0000")) == ["AC", "B"]
    assert names(cut(A__shadow__blend="normal")) == ["A", "BC"]


def test_every_part_of_the_look_tells_shadows_apart() -> None:
    for name, value in (("opacity", 0.5), ("color", "#FF0000"), ("blend", "normal"), ("fade", 90.0)):
        assert names(cut(**{f"B__shadow__{name}": value})) == ["AC", "B"]
    tips = {f"{name}__shadow__tip_distance": 80.0 for name in "ABC"}
    assert names(cut(**tips)) == ["ABC"]
    assert names(cut(**tips, C__shadow__tip_color="#FF0000")) == ["AB", "C"]


def test_hidden_layers_and_empty_cels_are_in_no_group() -> None:
    assert names(cut(B__visible=False)) == ["AC"]
    assert names(cut(), frame=9) == []


def test_a_look_that_is_keyed_unites_while_it_is_alike() -> None:
    document = cut()
    for frame, opacity in ((1, 0.6), (5, 0.2)):
        document = edits.set_key(document, resolve(document, "layers.B.shadow.opacity"), frame, opacity)
    assert [names(document, frame) for frame in (1, 2, 8)] == [["ABC"], ["AC", "B"], ["AC", "B"]]


def test_each_stays_alone_where_shadows_shall_not_unite() -> None:
    document = cut()
    document = edits.set_constant(document, resolve(document, "scene.shadows_unite"), False)  # noqa: FBT003 - the call's own order
    assert names(document) == ["A", "B", "C"]


def test_a_united_shadow_has_faded_already() -> None:
    look = ShadowLook((1, 2, 3), 0.5, multiply=True, fade=Fade(90.0, 1.0))
    assert united_look(look) == ShadowLook((1, 2, 3), 0.5, multiply=True)
