import os
from pathlib import Path

import numpy as np
import pytest

from kagezou.document.edits import add_layer, set_background, set_exposures
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import InputProblem
from kagezou.export.ledger import LEDGER_NAME
from kagezou.export.request import SUFFIXES, ExportRequest
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from kagezou.render.gpu.context import GraphicsContext
from tests.export.small_cuts import HEIGHT, WIDTH, bytes_below, cut, drawings, export, with_key, with_values


def no_context() -> GraphicsContext:
    raise AssertionError("nothing was to be drawn")


def two_layers(folder: Path) -> Document:
    document = cut(folder)
    shown = drawings(folder / "more", 3, "b")
    document = add_layer(
        document, "B", Cels(shown, (Exposure(2, 0), Exposure(3, None), Exposure(5, 1))), Box(1, 1, 2, 2)
    )
    return with_values(document, layers__B__shadow__color="#FF0000", layers__B__shadow__opacity=1.0)


def test_a_layer_is_one_colour_and_straight_alpha(tmp_path: Path) -> None:
    summary = export(cut(tmp_path), tmp_path / "out")
    assert (summary.files, summary.written, summary.drawn, summary.is_whole) == (6, 6, 6, True)
    assert summary.folders == (tmp_path / "out" / "A_shadow",)
    cel = read_cel(tmp_path / "out" / "A_shadow" / "A_shadow_0003.png")
    assert cel.rgba.shape == (HEIGHT, WIDTH, 4)
    assert (cel.rgba[..., :3] == (0x20, 0x20, 0x3A)).all()
    assert cel.rgba[..., 3].max() == round(0.6 * 255)


def test_a_held_drawing_is_drawn_once_and_its_bytes_are_used_again(tmp_path: Path) -> None:
    summary = export(cut(tmp_path, count=2, length=9), tmp_path / "out")
    assert (summary.files, summary.drawn) == (9, 2)
    frames = list(bytes_below(tmp_path / "out").values())
    assert len(frames) == 9
    assert len(set(frames)) == 2


def test_empty_cels_and_hidden_layers_give_empty_frames(tmp_path: Path) -> None:
    document = with_key(two_layers(tmp_path), "layers.A.visible", 1, value=True)
    document = with_key(document, "layers.A.visible", 4, value=False)
    export(document, tmp_path / "out")
    frames = bytes_below(tmp_path / "out")
    assert len(frames) == 12
    for name in ("B_shadow/B_shadow_0001", "B_shadow/B_shadow_0004", "A_shadow/A_shadow_0005"):
        cel = read_cel(tmp_path / "out" / f"{name}.png")
        assert cel.rgba.shape == (HEIGHT, WIDTH, 4)
        assert not cel.rgba[..., 3].any()
        assert (cel.rgba[..., :3] == cel.rgba[0, 0, :3]).all()
    assert read_cel(tmp_path / "out" / "B_shadow" / "B_shadow_0005.png").rgba[..., 3].any()


def test_the_composite_shows_everything(tmp_path: Path) -> None:
    (background,) = drawings(tmp_path / "back", 1, "back")
    document = set_background(two_layers(tmp_path), background.path)
    summary = export(document, tmp_path / "out", composite=True)
    assert summary.files == 18
    assert summary.folders[-1] == tmp_path / "out" / "composite"
    pixels = read_cel(tmp_path / "out" / "composite" / "composite_0001.png").rgba
    assert tuple(pixels[30, 15]) == (200, 120, 40, 255)
    assert len({frame for name, frame in bytes_below(tmp_path / "out").items() if "composite" in name}) > 3


@pytest.mark.parametrize("workers", [2, 5])
def test_the_bytes_do_not_depend_on_the_number_of_workers(tmp_path: Path, workers: int) -> None:
    document = two_layers(tmp_path)
    export(document, tmp_path / "one", composite=True, workers=1)
    export(document, tmp_path / "many", composite=True, workers=workers)
    assert bytes_below(tmp_path / "one") == bytes_below(tmp_path / "many")


def test_the_bytes_do_not_depend_on_which_frames_are_made_together(tmp_path: Path) -> None:
    document = with_key(two_layers(tmp_path), "light.position", 1, [10, -20, 40])
    document = with_key(document, "light.position", 6, [50, -25, 60])
    export(document, tmp_path / "whole")
    for frames in ((5, 6), (2,), (1, 3, 4)):
        export(document, tmp_path / "parts", frames=frames)
    assert bytes_below(tmp_path / "whole") == bytes_below(tmp_path / "parts")


@pytest.mark.parametrize(("kind", "depth"), [("png", 16), ("tga", 8), ("tiff", 8), ("tiff", 16), ("exr", 16)])
def test_every_format_and_depth_reads_back(tmp_path: Path, kind: str, depth: int) -> None:
    document = cut(tmp_path, count=2, length=3)
    for folder in ("out", "again"):
        export(document, tmp_path / folder, format=kind, depth=depth, composite=True)
    frames = bytes_below(tmp_path / "out")
    assert frames == bytes_below(tmp_path / "again")
    assert len(frames) == 6
    cel = read_cel(tmp_path / "out" / "A_shadow" / f"A_shadow_0002{SUFFIXES[kind]}")
    assert cel.rgba[..., 3].max() / np.iinfo(cel.rgba.dtype).max == pytest.approx(0.6, abs=0.003)


def test_frames_that_are_whole_and_the_same_are_left_alone(tmp_path: Path) -> None:
    document = two_layers(tmp_path)
    first = export(document, tmp_path / "out")
    again = export(document, tmp_path / "out", skip_existing=True, open_context=no_context)
    assert (again.trusted, again.written, again.is_whole) == (first.files, 0, True)


@pytest.mark.parametrize("content", [b"", b"half", None])
def test_frames_that_are_not_whole_are_made_again(tmp_path: Path, content: bytes | None) -> None:
    document = cut(tmp_path)
    export(document, tmp_path / "out")
    whole = bytes_below(tmp_path / "out")
    harmed = tmp_path / "out" / "A_shadow" / "A_shadow_0004.png"
    if content is None:
        harmed.unlink()
    else:
        harmed.write_bytes(content or b"")
    summary = export(document, tmp_path / "out", skip_existing=True)
    assert (summary.trusted, summary.written) == (5, 1)
    assert bytes_below(tmp_path / "out") == whole


def test_frames_of_other_values_or_drawings_are_made_again(tmp_path: Path) -> None:
    document = cut(tmp_path)
    export(document, tmp_path / "out")
    changed = with_key(document, "layers.A.shadow.opacity", 1, 0.6)
    changed = with_key(changed, "layers.A.shadow.opacity", 6, 0.3)
    assert export(changed, tmp_path / "out", skip_existing=True).trusted == 1
    assert export(changed, tmp_path / "out", skip_existing=True, open_context=no_context).written == 0
    os.utime(tmp_path / "drawings" / "a_0002.png", (1, 1))
    assert export(changed, tmp_path / "out", skip_existing=True).written == 1


def test_a_frame_that_no_ledger_knows_is_not_trusted(tmp_path: Path) -> None:
    document = cut(tmp_path)
    export(document, tmp_path / "out")
    (tmp_path / "out" / LEDGER_NAME).unlink()
    assert export(document, tmp_path / "out", skip_existing=True).written == 6


def test_a_cancelled_export_leaves_whole_frames_and_can_go_on(tmp_path: Path) -> None:
    document = two_layers(tmp_path)
    export(document, tmp_path / "whole")
    # One worker, so that few pictures are under way when it is stopped, however slow the machine is.
    stopped = export(document, tmp_path / "out", stop_after=1, workers=1)
    assert stopped.cancelled
    assert not stopped.is_whole
    some = bytes_below(tmp_path / "out")
    assert 1 <= len(some) < 12
    whole = bytes_below(tmp_path / "whole")
    assert some.items() <= whole.items()
    rest = export(document, tmp_path / "out", skip_existing=True)
    assert rest.trusted == len(some)
    assert bytes_below(tmp_path / "out") == whole


def test_missing_drawings_are_all_named_before_the_first_frame(tmp_path: Path) -> None:
    document = cut(tmp_path)
    for number in (2, 5):
        (tmp_path / "drawings" / f"a_{number:04d}.png").unlink()
    with pytest.raises(InputProblem, match=r"2 drawings are missing: .*a_0002\.png, .*a_0005\.png$"):
        export(document, tmp_path / "out", open_context=no_context)
    assert not (tmp_path / "out").exists()
    assert export(document, tmp_path / "out", frames=(1, 3)).is_whole


def test_one_missing_drawing_is_named_alone(tmp_path: Path) -> None:
    document = cut(tmp_path)
    (tmp_path / "drawings" / "a_0002.png").unlink()
    with pytest.raises(InputProblem, match=r"a_0002\.png: the drawing is missing$"):
        export(document, tmp_path / "out", open_context=no_context)


def test_going_on_past_drawings_that_cannot_be_read(tmp_path: Path) -> None:
    document = cut(tmp_path, count=6, length=8)
    (tmp_path / "drawings" / "a_0002.png").unlink()
    (tmp_path / "drawings" / "a_0006.png").write_bytes(b"no picture")
    summary = export(document, tmp_path / "out", keep_going=True, workers=3)
    assert [failure.frames for failure in summary.failures] == [(2,), (6, 7, 8)]
    assert "a_0006.png" in str(summary.failures[1].message)
    assert (summary.written, summary.cancelled, summary.is_whole) == (4, False, False)
    assert len(bytes_below(tmp_path / "out")) == 4


def test_a_damaged_drawing_ends_the_export(tmp_path: Path) -> None:
    document = cut(tmp_path)
    path = tmp_path / "drawings" / "a_0004.png"
    path.write_bytes(path.read_bytes()[:60])
    with pytest.raises(InputProblem, match=r"a_0004\.png"):
        export(document, tmp_path / "out")
    assert set(bytes_below(tmp_path / "out")) <= {f"A_shadow/A_shadow_{n:04d}.png" for n in (1, 2, 3)}


def test_layer_names_that_no_system_takes_are_replaced_and_told(tmp_path: Path) -> None:
    summary = export(cut(tmp_path, count=1, name="a/b:c"), tmp_path / "out")
    assert summary.names == {"a/b:c": "a_b_c"}
    assert list(bytes_below(tmp_path / "out")) == ["a_b_c_shadow/a_b_c_shadow_0001.png"]


def test_a_relative_folder_is_where_one_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    summary = export(cut(tmp_path, count=1), Path("here/out"))
    assert summary.folders == (tmp_path / "here" / "out" / "A_shadow",)


def test_a_cut_of_nothing_but_empty_cels_is_made(tmp_path: Path) -> None:
    document = cut(tmp_path, count=1, length=3)
    document = set_exposures(document, document.layers[0].id, (Exposure(1, None),))
    summary = export(document, tmp_path / "out")
    assert (summary.written, summary.drawn) == (3, 1)


def test_progress_counts_every_file(tmp_path: Path) -> None:
    document = cut(tmp_path, count=3, length=7)
    seen: list[tuple[int, int]] = []
    from kagezou.export.frames import export_frames
    from kagezou.render.gpu.context import open_headless_context

    request = ExportRequest(tmp_path / "out")
    export_frames(document, request, open_headless_context, lambda *step: seen.append(step), lambda: False)
    assert seen == [(1, 7), (2, 7), (7, 7)]


@pytest.mark.skipif(os.name == "nt", reason="links need a right there")
@pytest.mark.parametrize("form", ["png", "tga", "exr"])
def test_a_frame_takes_the_place_of_a_link(tmp_path: Path, form: str) -> None:
    document = cut(tmp_path, count=2)
    precious = tmp_path / "precious"
    precious.write_bytes(b"somebody's work")
    folder = tmp_path / "out" / "A_shadow"
    folder.mkdir(parents=True)
    for number in (1, 2):
        (folder / f"A_shadow_000{number}.{form}").symlink_to(precious)
    export(document, tmp_path / "out", format=form, depth=16 if form == "exr" else 8)
    assert not any(path.is_symlink() for path in folder.iterdir())
    assert precious.read_bytes() == b"somebody's work"
