"""Exporting scenes: what an export before left, what one that is stopped leaves, and what stands in the way."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.edits import set_canvas
from kagezou.errors import InputProblem, UsageProblem
from kagezou.export.exchange.blender import BLENDER
from kagezou.export.exchange.drawn import Who
from kagezou.export.exchange.export import SceneRequest, export_scene
from kagezou.export.exchange.fusion import FUSION
from kagezou.export.exchange.gathering import labels_of, ordered
from kagezou.export.exchange.nuke import NUKE
from kagezou.render.gpu.context import open_headless_context
from tests.export.exchange.cuts import NAME, made, rich_cut
from tests.export.small_cuts import bytes_below, cut


def test_scenes_of_several_programs_in_one_folder_stay_whole(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    for target in (BLENDER, NUKE, FUSION):
        made(document, tmp_path / target.pictures, target)
        made(document, tmp_path / "all", target)
    apart = {}
    for target in (BLENDER, NUKE, FUSION):
        apart.update(bytes_below(tmp_path / target.pictures))
    assert bytes_below(tmp_path / "all") == apart


def test_a_shorter_export_leaves_nothing_of_the_one_before(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    for target in (BLENDER, NUKE):
        made(document, tmp_path / "again", target)
        (tmp_path / "again" / target.pictures / "background" / "mine_0001.png").write_bytes(b"")
        made(document, tmp_path / "again", target, frames=(2, 3))
        made(document, tmp_path / "fresh", target, frames=(2, 3))
    found = bytes_below(tmp_path / "again")
    assert {name for name in found if not name.endswith("mine_0001.png")} == set(bytes_below(tmp_path / "fresh"))
    assert sum(name.endswith("mine_0001.png") for name in found) == 2, "what is not numbered as ours stays"


@pytest.mark.parametrize("workers", [1, 4])
def test_the_bytes_do_not_depend_on_the_workers(workers: int, tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    for folder, count in (("one", 1), ("other", workers)):
        made(document, tmp_path / folder, BLENDER, workers=count)
    assert bytes_below(tmp_path / "one") == bytes_below(tmp_path / "other")


def test_an_export_that_is_stopped_leaves_no_scene(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    done: list[int] = []
    request = SceneRequest(tmp_path / "out", NAME, "a.nk", NUKE, workers=1)
    came = export_scene(
        document, request, open_headless_context, lambda at, _all: done.append(at), lambda: len(done) > 2
    )
    assert (came.scene, came.written < 40) == (None, True)
    assert not (tmp_path / "out" / "a.nk").exists()
    assert sum(each.files - each.there for each in came.counts) == 1, "it is not whole"


def test_what_stands_in_the_way_is_said_before_anything_is_drawn(tmp_path: Path) -> None:
    document = cut(tmp_path / "in")
    huge = set_canvas(document, replace(document.canvas, width_px=20000))
    with pytest.raises(UsageProblem, match="at most 16384 px a side"):
        made(huge, tmp_path / "out", BLENDER)
    document.layers[0].cels.drawings[0].path.unlink()
    with pytest.raises(InputProblem, match="the drawing is missing"):
        made(document, tmp_path / "out", BLENDER)
    assert not (tmp_path / "out").exists()


def test_layers_that_come_later_are_fitted_in() -> None:
    a, b, c, d = (Who(name) for name in "abcd")
    assert ordered([(a, c), (a, b, c), (b, d), (a, c)]) == (a, b, c, d)
    assert ordered([(b,), (a, b)]) == (a, b)


def test_folders_have_names_that_no_program_takes_for_a_pattern() -> None:
    names = ("影 %04d", "a#1", "a_1", "A_1", "$HOME", "x[1]", "b{c}", "影 _04d")
    labels = list(labels_of([Who(name) for name in names] + [Who("a_1", is_group=True)]).values())
    assert labels[:2] == ["影 _04d", "a_1"]
    assert len({label.casefold() for label in labels}) == len(labels)
    assert not any(sign in label for label in labels for sign in "%#$[]{}")
