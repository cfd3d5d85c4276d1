from pathlib import Path

import pytest

from kagezou.document.edits import add_layer, set_exposures
from kagezou.document.model import Cels, Document, Exposure
from kagezou.errors import UsageProblem
from kagezou.export import planning
from kagezou.export.planning import planned
from kagezou.export.request import ExportRequest
from kagezou.geometry.box import Box
from tests.export.small_cuts import cut, with_key, with_values


def names_of(document: Document, request: ExportRequest) -> list[str]:
    return sorted(target.path.name for job in planned(document, request).jobs for target in job.targets)


def test_a_held_drawing_is_one_picture_of_many_files(tmp_path: Path) -> None:
    plan = planned(cut(tmp_path, count=2, length=10), ExportRequest(tmp_path))
    assert [len(job.targets) for job in plan.jobs] == [1, 9]
    assert plan.files == 10


def test_a_drawing_that_comes_again_is_the_same_picture(tmp_path: Path) -> None:
    document = cut(tmp_path, count=2, length=4)
    layer = document.layers[0]
    document = set_exposures(document, layer.id, tuple(Exposure(frame, (frame - 1) % 2) for frame in (1, 2, 3, 4)))
    plan = planned(document, ExportRequest(tmp_path))
    assert [[target.frame for target in job.targets] for job in plan.jobs] == [[1, 3], [2, 4]]


def test_a_moving_light_makes_each_frame_a_picture(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path, count=1, length=5), "light.position", 1, [10, -20, 40])
    document = with_key(document, "light.position", 5, [50, -20, 40])
    assert len(planned(document, ExportRequest(tmp_path)).jobs) == 5


def test_numbers_are_those_of_the_project(tmp_path: Path) -> None:
    request = ExportRequest(tmp_path, frames=(5, 6, 7, 8))
    assert names_of(cut(tmp_path, length=12), request) == [f"A_shadow_{n:04d}.png" for n in (5, 6, 7, 8)]


def test_long_cuts_have_one_more_digit_everywhere(tmp_path: Path) -> None:
    request = ExportRequest(tmp_path, frames=(7,))
    assert names_of(cut(tmp_path, length=10001), request) == ["A_shadow_00007.png"]


def test_a_layer_hidden_for_a_while_has_no_gap(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path, length=6), "layers.A.visible", 1, value=False)
    document = with_key(document, "layers.A.visible", 4, value=True)
    assert len(names_of(document, ExportRequest(tmp_path))) == 6


def test_a_layer_never_seen_is_made_only_when_named(tmp_path: Path) -> None:
    document = with_values(cut(tmp_path), layers__A__visible=False)
    with pytest.raises(UsageProblem, match="no visible character layer"):
        planned(document, ExportRequest(tmp_path))
    assert len(names_of(document, ExportRequest(tmp_path, layers=("A",)))) == 6


def test_a_layer_that_is_not_there_is_told_with_the_nearest(tmp_path: Path) -> None:
    document = add_layer(cut(tmp_path), "Heroine", Cels(), Box(0, 0, 1, 1))
    with pytest.raises(UsageProblem, match="did you mean 'Heroine'"):
        planned(document, ExportRequest(tmp_path, layers=("Heroin",)))


@pytest.mark.parametrize("frames", [(0,), (7,), (1, 99), ()])
def test_frames_beyond_the_cut_are_refused(tmp_path: Path, frames: tuple[int, ...]) -> None:
    with pytest.raises(UsageProblem, match="1-6"):
        planned(cut(tmp_path), ExportRequest(tmp_path, frames=frames))


def test_one_layer_keeps_the_name_it_has_among_all(tmp_path: Path) -> None:
    document = add_layer(cut(tmp_path, name="a/b"), "a:b", Cels(), Box(0, 0, 1, 1))
    whole = planned(document, ExportRequest(tmp_path)).names
    assert planned(document, ExportRequest(tmp_path, layers=("a:b",))).names == {"a:b": whole["a:b"]}


@pytest.mark.parametrize(("kind", "depth"), [("jpg", 8), ("tga", 16), ("exr", 8), ("png", 12)])
def test_formats_and_depths_that_do_not_exist(tmp_path: Path, kind: str, depth: int) -> None:
    with pytest.raises(UsageProblem):
        ExportRequest(tmp_path, format=kind, depth=depth)


def test_a_canvas_that_the_machine_cannot_draw_is_refused_before_it_is_drawn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = cut(tmp_path, count=1)
    pixels = document.canvas.width_px * document.canvas.height_px
    monkeypatch.setattr(planning, "free_memory", lambda: 20 * pixels)
    assert planned(document, ExportRequest(tmp_path)).files
    with pytest.raises(UsageProblem, match=r"needs about \d+ MB of memory to be drawn"):
        planned(document, ExportRequest(tmp_path, composite=True))
    monkeypatch.setattr(planning, "free_memory", lambda: None)
    assert planned(document, ExportRequest(tmp_path, composite=True)).files
