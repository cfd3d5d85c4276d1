"""What characters cast on each other, as layers of their own."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, set_canvas
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import UsageProblem
from kagezou.export.after_effects.export import HandOffRequest, export_to_after_effects
from kagezou.export.request import RECEIVED, SHADOWS
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from kagezou.io.images.writing import write_rgba
from kagezou.io.psd.file import psd_tree
from kagezou.picture_source import PicturePart
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import cut, drawings, export, with_key, with_values


@pytest.fixture
def duo(tmp_path: Path) -> Document:
    """A block that walks behind one that stands; the lamp stands before them on the left."""
    document = cut(tmp_path, count=4)
    other = drawings(tmp_path / "more", 1, "b")
    document = add_layer(document, "B", Cels(other, (Exposure(1, 0),)), Box(12, 20, 20, 40))
    return with_values(
        document,
        **{
            "layers.A.receives": True,
            "layers.A.grounding": [[16, 36]],
            "layers.B.grounding": [[14, 44]],
            "light.position": [8, -10, 90],
            "layers.B.shadow.color": "#803010",
            "layers.B.shadow.opacity": 0.5,
        },
    )


def test_each_receiving_character_has_a_folder_of_its_own(tmp_path: Path, duo: Document) -> None:
    summary = export(duo, tmp_path / "out", composite=True)
    assert [folder.name for folder in summary.folders] == ["A_shadow", "B_shadow", "A_received", "composite"]
    assert summary.files == 16
    cel = read_cel(tmp_path / "out" / "A_received" / "A_received_0001.png")
    assert cel.rgba[0, 0].tolist() == [0x80, 0x30, 0x10, 0]
    assert cel.rgba[..., 3].max() == 128
    drawing = read_cel(duo.layers[0].cels.drawings[0].path).rgba
    assert not cel.rgba[..., 3][drawing[..., 3] == 0].any()


def test_frames_without_a_drawing_or_a_caster_are_empty_and_the_sequence_has_no_gap(
    tmp_path: Path, duo: Document
) -> None:
    hidden = duo
    for frame, seen in ((1, True), (3, False)):
        hidden = with_key(hidden, "layers.B.visible", frame, seen)
    export(hidden, tmp_path / "out")
    most = [read_cel(path).rgba[..., 3].max() for path in sorted((tmp_path / "out" / "A_received").glob("*.png"))]
    assert most == [128, 128, 0, 0]
    assert export(hidden, tmp_path / "out", skip_existing=True).drawn == 0


def test_a_layer_alone_brings_what_it_receives_and_parts_may_be_asked_for(tmp_path: Path, duo: Document) -> None:
    assert len(export(duo, tmp_path / "a", layers=("A",)).folders) == 2
    assert [folder.name for folder in export(duo, tmp_path / "b", only=RECEIVED).folders] == ["A_received"]
    names = [folder.name for folder in export(duo, tmp_path / "c", only=SHADOWS).folders]
    assert names == ["A_shadow", "B_shadow"]
    with pytest.raises(UsageProblem, match="there is nothing to render"):
        export(duo, tmp_path / "d", layers=("B",), only=RECEIVED)


def test_a_change_of_a_caster_draws_anew_what_others_receive(tmp_path: Path, duo: Document) -> None:
    export(duo, tmp_path / "out", only=RECEIVED)
    moved = with_values(duo, **{"layers.B.grounding": [[15, 45]]})
    assert export(moved, tmp_path / "out", only=RECEIVED, skip_existing=True).drawn == 4
    path = duo.layers[1].cels.drawings[0].path
    write_rgba(path, read_cel(path).rgba[:, ::-1].copy())
    assert export(duo, tmp_path / "out", only=RECEIVED, skip_existing=True).drawn == 4


def test_held_frames_are_drawn_once(tmp_path: Path, duo: Document) -> None:
    longer = set_canvas(duo, replace(duo.canvas, length_frames=9))
    summary = export(longer, tmp_path / "out", only=RECEIVED)
    assert (summary.files, summary.drawn) == (9, 4)


@pytest.mark.parametrize("per_drawing", [False, True])
def test_after_effects_lays_it_over_the_character(tmp_path: Path, duo: Document, *, per_drawing: bool) -> None:
    request = HandOffRequest(folder=tmp_path / "ae", name="cut", per_drawing=per_drawing, mattes=("shadow",))
    export_to_after_effects(duo, request, open_headless_context, lambda _done, _all: None, lambda: False)
    script = (tmp_path / "ae" / "cut.jsx").read_text(encoding="ascii")
    assert script.index('"cels:layer-1"') < script.rindex('"received:layer-1"')
    assert "A_received/A_received_" in script
    assert (tmp_path / "ae" / "shadows" / "A_received").is_dir()
    assert not list((tmp_path / "ae" / "matte_shadow").glob("*_received"))
    # At the opacity of the caster: After Effects has none of its own for it.
    assert read_cel(tmp_path / "ae" / "shadows" / "A_received" / "A_received_0001.png").rgba[..., 3].max() == 128


def test_a_frame_of_layers_has_it_over_the_character(tmp_path: Path, duo: Document) -> None:
    export(duo, tmp_path / "out", only=RECEIVED)
    export(duo, tmp_path / "out", layered=True, format="psd")
    frame = next((tmp_path / "out" / "layered").glob("*_0001.psd"))
    assert [node.name for node in psd_tree(frame).layers] == ["A_shadow", "B_shadow", "A", "A_received", "B"]
    layer = read_cel(PicturePart(frame, "A_received")).rgba[..., 3]
    assert np.array_equal(layer, read_cel(tmp_path / "out" / "A_received" / "A_received_0001.png").rgba[..., 3])
    hidden = with_values(duo, **{"layers.B.visible": False})
    export(hidden, tmp_path / "none", layered=True, format="psd")
    frame = next((tmp_path / "none" / "layered").glob("*_0001.psd"))
    assert [(node.name, node.is_empty) for node in psd_tree(frame).layers][-1] == ("A_received", True)
