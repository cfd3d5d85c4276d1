"""Pictures as arrays: the same as in files, in order, on one thread."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import kagezou
from kagezou.interface.cut import Cut
from tests.cli.projects import make_drawings


def test_they_are_the_pictures_of_the_files(cut: Cut, tmp_path: Path) -> None:
    cut.export(kagezou.Frames(tmp_path / "out", composite=True))
    for name in ("Hero_shadow", "composite"):
        assert name in cut.sequences
        for frame, pixels in cut.pictures(name):
            with Image.open(tmp_path / "out" / name / f"{name}_{frame:04d}.png") as written:
                assert np.array_equal(np.asarray(written), pixels)


def test_numbers(cut: Cut) -> None:
    (eight,), (sixteen,), (real,) = (
        cut.pictures("composite", "2", numbers=numbers) for numbers in ("uint8", "uint16", "float32")
    )
    assert [each.pixels.dtype for each in (eight, sixteen, real)] == [np.uint8, np.uint16, np.float32]
    assert eight.pixels.shape == (48, 64, 4)
    assert not eight.pixels.flags.writeable
    assert np.array_equal(np.round(real.pixels * 65535), sixteen.pixels)
    assert np.abs(sixteen.pixels / 257 - eight.pixels).max() <= 1
    assert real.pixels.max() == 1.0


def test_frames_come_in_order_and_those_that_return_as_well(drawings: Path) -> None:
    for number, like in ((4, 1), (5, 2)):
        (drawings / f"walk_{number:04d}.png").write_bytes((drawings / f"walk_{like:04d}.png").read_bytes())
    told: list[tuple[int, int]] = []
    longer = kagezou.new({"Hero": drawings}).with_value("canvas.length", 6)
    found = list(longer.pictures("Hero_shadow", progress=lambda done, whole: told.append((done, whole))))
    assert [each.frame for each in found] == [1, 2, 3, 4, 5, 6]
    assert told == [(number, 6) for number in range(1, 7)]
    assert found[4].pixels is found[5].pixels
    assert np.array_equal(found[0].pixels, found[3].pixels)
    assert [frame for frame, _ in longer.pictures("composite", [5, 2])] == [2, 5]


def test_two_are_drawn_in_turns_and_one_is_left_early(cut: Cut) -> None:
    alone = {name: list(cut.pictures(name)) for name in ("Hero_shadow", "composite")}
    in_turns = list(zip(cut.pictures("Hero_shadow"), cut.pictures("composite"), strict=True))
    for index, name in enumerate(alone):
        for pair, single in zip(in_turns, alone[name], strict=True):
            assert np.array_equal(pair[index].pixels, single.pixels)
    left = cut.pictures("composite")
    next(left)
    del left
    assert len(list(cut.pictures("composite"))) == 3


def test_with_many_frames_two_draw_and_nothing_is_otherwise(tmp_path: Path) -> None:
    cut = kagezou.new({"Hero": make_drawings(tmp_path / "many", 9)})
    cut.export(kagezou.Frames(tmp_path / "out"))
    turns = zip(cut.pictures("Hero_shadow"), cut.pictures("composite"), cut.pictures("Hero_shadow"), strict=True)
    for (frame, shadow), (_, whole), (_, again) in turns:
        with Image.open(tmp_path / "out" / "Hero_shadow" / f"Hero_shadow_{frame:04d}.png") as written:
            assert np.array_equal(np.asarray(written), shadow)
        assert np.array_equal(shadow, again)
        assert whole[..., 3].any()
    left = cut.pictures("composite")
    assert [next(left).frame, next(left).frame] == [1, 2]
    left.close()
    assert len(list(cut.pictures("composite", "3-9"))) == 7


def test_they_can_be_stopped(cut: Cut) -> None:
    taken: list[int] = []
    for frame, _ in cut.pictures("composite", stop=lambda: True):
        taken.append(frame)
    assert taken == []


def test_another_thread_may_draw_but_not_go_on(cut: Cut) -> None:
    with ThreadPoolExecutor(1) as pool:
        elsewhere = pool.submit(lambda: [each.pixels for each in cut.pictures("composite")]).result()
        here = cut.pictures("composite")
        assert np.array_equal(next(here).pixels, elsewhere[0])
        with pytest.raises(kagezou.UsageProblem, match="thread that took the first"):
            pool.submit(next, here).result()


def test_what_there_is_not(cut: Cut, drawings: Path) -> None:
    with pytest.raises(kagezou.UsageProblem, match="no pictures 'Villain_shadow', only Hero_shadow"):
        cut.pictures("Villain_shadow")
    with pytest.raises(kagezou.UsageProblem, match="frame 9"):
        cut.pictures("composite", "9")
    with pytest.raises(kagezou.UsageProblem, match="no frame: frames are whole"):
        cut.pictures("composite", [1.5])  # type: ignore[list-item]
    with pytest.raises(kagezou.UsageProblem, match="only as uint8, uint16, float32"):
        cut.pictures("composite", numbers="float16")  # type: ignore[arg-type]
    assert [frame for frame, _ in cut.pictures("composite", np.arange(2, 4))] == [2, 3]
    (drawings / "walk_0002.png").unlink()
    with pytest.raises(kagezou.InputProblem, match=r"walk_0002\.png"):
        cut.pictures("composite")
