"""What pictures show: when two are the same, what they are made of, and how each draws itself."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kagezou.document.edits import set_background, set_exposures
from kagezou.document.model import Document, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.export.contents import (
    BlankContent,
    CompositeContent,
    Content,
    ReceiverContent,
    SetShadowContent,
    ShadowContent,
)
from kagezou.export.layered import LayeredContent
from kagezou.export.mixed_contents import ReceivedContent
from kagezou.export.painter import Painter
from kagezou.export.pictures import FlatPicture, LayeredPicture, Picture, ShadowPicture
from kagezou.export.request import ExportRequest
from kagezou.export.sequences import sequences_of
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.writing import write_rgba
from kagezou.render.gpu.context import open_headless_context
from kagezou.render.renderer import Renderer
from kagezou.scene.evaluate import evaluate
from tests.export.small_cuts import HEIGHT, WIDTH, cut, with_values

EVERYTHING: dict[str, Any] = {"composite": True, "receivers": True}


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Two drawings that receive, a wall that casts, a background, and an empty cel on frame 3."""
    made = with_values(cut(tmp_path, count=2, length=3), layers__A__receives=True)
    shown = (Exposure(1, 0), Exposure(2, 1), Exposure(3, None))
    made = add_piece(set_exposures(made, "layer-1", shown), "wall", "wall", {"width": 60.0, "height": 20.0})
    write_rgba(tmp_path / "bg.png", np.full((HEIGHT, WIDTH, 4), 255, np.uint8))
    return set_background(with_values(made, set__wall__casts=True), tmp_path / "bg.png")


def contents(document: Document, frame: int = 1, **wishes: object) -> dict[str, Content]:
    """Return what each sequence shows on a frame, by the names of their folders."""
    scene = evaluate(document, frame)
    request = ExportRequest(Path("out"), **wishes)  # type: ignore[arg-type]
    return {
        sequence.label: sequence.subject.content_at(document, scene, frame)
        for sequence in sequences_of(document, request)
    }


def drawn(content: Content, depth: int = 8, *, keeps_opacity: bool = False) -> Picture:
    with open_headless_context():
        renderer = Renderer(cels := CelCache(1 << 24))
        try:
            return content.draw(Painter(renderer, cels, depth, keeps_opacity))
        finally:
            renderer.close()


def test_each_subject_has_its_content(document: Document) -> None:
    found = contents(document, **EVERYTHING)
    assert {label: type(content) for label, content in found.items()} == {
        "A_shadow": ShadowContent,
        "A_received": BlankContent,
        "set_shadow": SetShadowContent,
        "ground_matte": ReceiverContent,
        "wall_matte": ReceiverContent,
        "composite": CompositeContent,
    }
    assert isinstance(contents(document, 3)["A_shadow"], BlankContent), "an empty cel"
    assert isinstance(contents(document, layered=True, format="psd")["layered"], LayeredContent)


def test_what_it_is_drawn_from_does_not_tell_contents_apart(document: Document) -> None:
    for label, content in contents(document, **EVERYTHING).items():
        again = contents(replace(document), **EVERYTHING)[label]
        assert content.scene is not again.scene
        assert (content, hash(content), repr(content)) == (again, hash(again), repr(again))
        assert content == replace(content, scene=evaluate(with_values(document, camera__fov=20), 1))


def test_contents_of_another_look_differ(document: Document) -> None:
    paler = contents(with_values(document, layers__A__shadow__opacity=0.4), **EVERYTHING)
    before = contents(document, **EVERYTHING)
    assert [label for label, content in before.items() if paler[label] != content] == ["A_shadow", "composite"]


def test_what_a_shadow_is_laid_on_with_does_not_change_it(document: Document) -> None:
    over = with_values(document, layers__A__shadow__blend="normal")
    assert contents(over)["A_shadow"] == contents(document)["A_shadow"]
    assert contents(over, **EVERYTHING)["composite"] != contents(document, **EVERYTHING)["composite"]


def test_each_content_says_what_it_is_made_of(document: Document, tmp_path: Path) -> None:
    drawing = tmp_path / "drawings" / "a_0001.png"
    found = contents(document, **EVERYTHING)
    assert found["A_shadow"].sources.mattes == (drawing,)
    assert found["A_received"].sources.files == ()
    assert found["composite"].sources.cels == (drawing,)
    assert found["composite"].sources.files == (drawing, tmp_path / "bg.png")
    assert found["set_shadow"].sources.files == found["wall_matte"].sources.files == ()
    assert [label for label, content in found.items() if content.is_filled] == ["composite"]
    layered = contents(document, layered=True, format="psd")["layered"]
    assert layered.sources == found["composite"].sources


def test_what_falls_on_a_character_is_made_of_all_that_cast(document: Document, tmp_path: Path) -> None:
    layer = document.layers[0]
    behind = replace(layer, id="layer-2", name="B", cels=cut(tmp_path / "b").layers[0].cels)
    pair = with_values(replace(document, layers=(layer, behind)), **{"layers.B.grounding": [[14, 44]]})
    content = contents(with_values(pair, **{"layers.A.grounding": [[16, 36]], "light.position": [8, -10, 90]}))
    received = content["A_received"]
    assert isinstance(received, ReceivedContent)
    folders = [path.parent.parent.name for path in received.sources.files]
    assert folders == [tmp_path.name, "b"]
    assert received.sources.cels == ()


@pytest.mark.parametrize("depth", [8, 16])
def test_each_content_draws_itself(document: Document, depth: int) -> None:
    kinds = {"composite": FlatPicture}
    for label, content in contents(document, **EVERYTHING).items():
        picture = drawn(content, depth)
        assert type(picture) is kinds.get(label, ShadowPicture)
        assert picture.rgba().shape == (HEIGHT, WIDTH, 4)
        assert picture.rgba().dtype == (np.uint8 if depth == 8 else np.uint16)
    blank = drawn(BlankContent(evaluate(document, 1), (1, 2, 3)), depth).rgba()
    assert np.unique(blank.reshape(-1, 4), axis=0).tolist() == [[1, 2, 3, 0] if depth == 8 else [257, 514, 771, 0]]


def test_a_frame_of_layers_is_merged_where_files_keep_that(document: Document) -> None:
    content = contents(document, layered=True, format="psd")["layered"]
    kept, apart = drawn(content, keeps_opacity=True), drawn(content)
    assert isinstance(kept, LayeredPicture)
    assert isinstance(apart, LayeredPicture)
    assert [part.name for part in kept.image.parts] == ["background", "set_shadow", "A_shadow", "A", "A_received"]
    assert kept.image.parts[2].opacity < 1
    assert apart.image.parts[2].opacity == 1
    whole = drawn(contents(document, **EVERYTHING)["composite"])
    assert (kept.rgba() == whole.rgba()).all()
    with pytest.raises(ValueError, match="not merged"):
        apart.rgba()


@pytest.mark.parametrize("suffix", [".png", ".tif", ".exr"])
def test_a_picture_returns_the_bytes_of_the_file_it_wrote(document: Document, tmp_path: Path, suffix: str) -> None:
    found = contents(document, **EVERYTHING)
    for label in ("A_shadow", "composite"):
        path = tmp_path / f"{label}{suffix}"
        assert drawn(found[label]).write(path) == path.read_bytes()
