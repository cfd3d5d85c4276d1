"""Masks of PSD files: painted ones and paths, on layers and groups, thinned and with soft edges."""

from dataclasses import replace
from math import erf, sqrt
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.io.images.reading import read_cel
from kagezou.picture_source import PicturePart
from tests.psd_files import SIZE, Cut, Folder, Leaf, block, write_psd

WHOLE = block(*SIZE)
HALF = np.zeros((SIZE[1], SIZE[0]), np.uint8)
HALF[:, 32:] = 255
RIGHT = (32.0, 0.0, 64.0, 48.0)


def alpha(path: Path, cut: Cut, *, on_group: bool = False) -> NDArray[np.float64]:
    """Return the alpha of an opaque layer that is cut itself or by its group, 0 to 255."""
    leaf = Leaf("1", WHOLE, cut=None if on_group else cut)
    write_psd(path / "a.psd", [Folder("A", [leaf, replace(leaf, name="2")], cut=cut if on_group else None)])
    return read_cel(PicturePart(path / "a.psd", "A/1")).rgba[..., 3].astype(float)


def soft(width_px: float) -> NDArray[np.float64]:
    """Return what an upright edge at 32 px becomes along x, blurred by a Gaussian of this deviation."""
    return np.array([255 * 0.5 * (1 + erf((x + 0.5 - 32) / (width_px * sqrt(2)))) for x in range(SIZE[0])])


@pytest.mark.parametrize("on_group", [False, True])
@pytest.mark.parametrize("cut", [Cut(HALF), Cut(path=RIGHT), Cut(HALF[:, 40:], (40, 0), 0)])
def test_what_is_outside_is_clear(tmp_path: Path, cut: Cut, *, on_group: bool) -> None:
    made = alpha(tmp_path, cut, on_group=on_group)
    edge = 40 if cut.corner[0] else 32
    assert set(np.unique(made[:, :edge])) == {0}
    assert set(np.unique(made[:, edge:])) == {255}


@pytest.mark.parametrize("on_group", [False, True])
def test_a_path_through_a_pixel_covers_a_part_of_it(tmp_path: Path, *, on_group: bool) -> None:
    made = alpha(tmp_path, Cut(path=(32.25, 0, 64, 48)), on_group=on_group)
    assert np.abs(made[4:-4, 32] - 0.75 * 255).max() <= 1


@pytest.mark.parametrize("on_group", [False, True])
@pytest.mark.parametrize("cut", [Cut(HALF, density=102), Cut(path=RIGHT, path_density=102)])
def test_a_thin_mask_cuts_in_part(tmp_path: Path, cut: Cut, *, on_group: bool) -> None:
    made = alpha(tmp_path, cut, on_group=on_group)
    assert set(np.unique(made[:, 32:])) == {255}
    assert np.abs(made[:, :32] - (255 - 102)).max() <= 1


@pytest.mark.parametrize("on_group", [False, True])
@pytest.mark.parametrize("width_px", [1.5, 5.0])
def test_the_edge_of_a_painted_mask_is_as_soft_as_the_file_says(
    tmp_path: Path, width_px: float, *, on_group: bool
) -> None:
    painted = np.zeros((SIZE[1] + 80, SIZE[0] + 40), np.uint8)
    painted[:, 32:] = 255
    wide = Cut(painted, (0, -40), feather=width_px)
    made = alpha(tmp_path, wide, on_group=on_group)
    assert np.abs(made[24] - soft(width_px)).max() <= 2


@pytest.mark.parametrize("width_px", [1.5, 4.0])
def test_the_edge_of_a_path_is_as_soft_as_the_file_says(tmp_path: Path, width_px: float) -> None:
    made = alpha(tmp_path, Cut(path=(32, -200, 300, 300), path_feather=width_px))
    assert np.abs(made[24] - soft(width_px)).max() <= 2


def test_both_masks_are_each_thinned_by_their_own_density(tmp_path: Path) -> None:
    lower = np.zeros((SIZE[1], SIZE[0]), np.uint8)
    lower[24:] = 255
    made = alpha(tmp_path, Cut(lower, density=51, path=RIGHT, path_density=153))
    painted, path = np.where(np.arange(48) < 24, 0.8, 1.0), np.where(np.arange(64) < 32, 0.4, 1.0)
    assert np.abs(made - 255 * painted[:, None] * path).max() <= 1


def test_a_mask_is_read_alike_every_time(tmp_path: Path) -> None:
    made = alpha(tmp_path, Cut(HALF, feather=3.0))
    again = read_cel(PicturePart(tmp_path / "a.psd", "A/1")).rgba[..., 3]
    assert np.array_equal(made, again)


def test_a_group_thins_and_cuts_each_of_its_drawings(tmp_path: Path) -> None:
    inner = Folder("A", [Leaf("1", WHOLE, opacity=128), Leaf("2", WHOLE, is_visible=False)], opacity=204)
    outer = Folder("all", [inner], opacity=153, is_visible=False, cut=Cut(HALF))
    path = write_psd(tmp_path / "a.psd", [outer])
    for name, opacity in (("1", 128), ("2", 255)):
        made = read_cel(PicturePart(path, f"all/A/{name}")).rgba[..., 3].astype(float)
        assert set(np.unique(made[:, :32])) == {0}
        assert np.abs(made[:, 32:] - opacity * 0.8 * 0.6).max() <= 1


def test_what_is_clipped_to_a_group_colours_its_drawings(tmp_path: Path) -> None:
    shade = Leaf("shade", block(*SIZE, (10, 20, 30, 255)), is_clipped=True)
    path = write_psd(tmp_path / "a.psd", [Folder("A", [Leaf("1", block(20, 20)), Leaf("2", block(9, 9))]), shade])
    made = read_cel(PicturePart(path, "A/1")).rgba
    assert made[5, 5].tolist() == [10, 20, 30, 255]
    assert made[30, 30, 3] == 0
