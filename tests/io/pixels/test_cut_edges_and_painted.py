"""What of a drawing casts: smoke that the picture's border cuts fades out, painted shadows are found and left out."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from kagezou.io.images.casting_mattes import CastingMattes, faded_at_cuts, painted_part, without_painted_shadow
from kagezou.io.images.cel_cache import CelCache
from kagezou.io.images.reading import matte_of, read_cel
from kagezou.io.images.writing import write_rgba

SIZE = 200


def smoke(*, at_left: bool = False, at_bottom: bool = False) -> NDArray[np.uint8]:
    alpha = np.zeros((SIZE, SIZE), np.uint8)
    alpha[60 : SIZE if at_bottom else 150, 0 if at_left else 40 : 150] = 120
    return alpha


def figure(*, shadow: tuple[int, int, int, int] | None = (20, 20, 40, 150)) -> NDArray[np.uint8]:
    """A character with dark anti-aliased outlines, and below it perhaps an ellipse of shadow."""
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    rgba = np.zeros((SIZE, SIZE, 4), np.uint8)
    if shadow is not None:
        rgba[((x - 100) / 60) ** 2 + ((y - 170) / 14) ** 2 <= 1] = shadow
    away = np.hypot((x - 100) / 35, (y - 100) / 72) - 1
    rgba[away <= 0] = (230, 200, 60, 255)
    line = np.abs(away) * 40
    rgba[line < 2] = (10, 10, 10, 255)
    rgba[(line >= 2) & (line < 3) & (away > 0)] = (10, 10, 10, 120)
    return rgba


def test_what_no_border_cuts_stays_as_it_is() -> None:
    matte = matte_of(smoke())
    assert faded_at_cuts(matte) is matte


@pytest.mark.parametrize("sides", [{"at_left": True}, {"at_bottom": True}, {"at_left": True, "at_bottom": True}])
def test_alpha_fades_out_toward_the_border_that_cuts_it(sides: dict[str, bool]) -> None:
    alpha = smoke(**sides)
    faded = faded_at_cuts(matte_of(alpha)).whole().astype(int)
    reach = int(0.08 * SIZE)
    inner = np.s_[60 : SIZE - reach, reach:150]
    assert np.array_equal(faded[inner], alpha[inner])
    if "at_left" in sides:
        ramp = faded[100, : reach + 1]
        assert ramp[0] <= 2
        assert (np.diff(ramp) >= 0).all()
        assert np.diff(ramp).max() < 20, "no step that is seen as a line"
        assert ramp[-1] == 120
    if "at_bottom" in sides:
        assert faded[-1].max() <= 2


def test_a_painted_shadow_is_found_and_outlines_are_none(tmp_path: Path) -> None:
    path, bare = tmp_path / "a.png", tmp_path / "b.png"
    write_rgba(path, figure())
    write_rgba(bare, figure(shadow=None))
    assert painted_part(read_cel(path)) > 0.1
    assert painted_part(read_cel(bare)) == 0.0
    found, wanted = without_painted_shadow(read_cel(path)).whole(), read_cel(bare).matte.whole()
    # Where the figure's soft outline lies on the shadow the two cannot be told apart.
    assert (np.abs(found.astype(int) - wanted) > 8).sum() < 120
    assert without_painted_shadow(read_cel(bare)).whole().sum() == wanted.sum()


@pytest.mark.parametrize("shadow", [(230, 230, 240, 150), (20, 20, 40, 255), (20, 20, 40, 10)])
def test_light_glass_solid_ground_and_a_breath_are_no_painted_shadow(
    tmp_path: Path, shadow: tuple[int, int, int, int]
) -> None:
    write_rgba(tmp_path / "a.png", figure(shadow=shadow))
    assert painted_part(read_cel(tmp_path / "a.png")) == 0.0


def test_a_veil_high_up_is_no_painted_shadow(tmp_path: Path) -> None:
    rgba = figure(shadow=None)
    rgba[30:60, 20:60] = (20, 20, 40, 150)
    write_rgba(tmp_path / "a.png", rgba)
    assert painted_part(read_cel(tmp_path / "a.png")) == 0.0


def test_each_is_made_once_of_a_drawing_that_is_kept(tmp_path: Path) -> None:
    write_rgba(tmp_path / "a.png", figure())
    casting = CastingMattes(CelCache())
    asked = [casting.matte(tmp_path / "a.png", translucent=False, without_painted=True) for _ in range(2)]
    assert asked[0] is asked[1]
    whole = casting.matte(tmp_path / "a.png", translucent=False, without_painted=False)
    assert whole.whole().sum() > asked[0].whole().sum()
