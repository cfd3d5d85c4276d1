"""Gaps along crests: how much of them is open, where none is, how they go with waves and loop."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.slits import LEAST_WIDTH, MOST_WIDTH, Slits
from kagezou.geometry.waves import Wave

SLITS = Slits(0.6, 40.0, 0.0, 100.0)
FAR_PX = 400.0


def grid(wide: float, deep: float, step: float = 1.0) -> tuple[np.ndarray, np.ndarray]:
    v, u = np.mgrid[0.0:deep:step, 0.0:wide:step]
    return u, v


def inside(slits: Slits, u: np.ndarray, v: np.ndarray, away: float = FAR_PX) -> np.ndarray:
    return slits.inside_px(u, v, np.full_like(u, away))


def runs(open_: np.ndarray) -> np.ndarray:
    """How long each run of open places in a column is."""
    edges = np.diff(np.pad(open_.astype(int), 1))
    return np.nonzero(edges < 0)[0] - np.nonzero(edges > 0)[0]


class TestShape:
    @pytest.mark.parametrize("share", [0.15, 0.6, 0.9, 1.0])
    def test_so_much_of_a_crest_is_open(self, share: float) -> None:
        """Each row crosses each column once: in a gap, or not."""
        v, u = np.mgrid[0.0:2400.0:0.5, 0.0:20_000.0:211.0]
        within = inside(replace(SLITS, share=share, growth=1.0), u, v, 9000.0) > 0
        gaps = sum(len(runs(column)) for column in within.T)
        assert gaps / (60 * within.shape[1]) == pytest.approx(share, abs=0.03)

    def test_no_gap_is_wider_than_it_may_be(self) -> None:
        v, u = np.mgrid[0.0:4000.0:0.5, 0.0:3000.0:101.0]
        for away, growth, widest in ((200.0, 0.0, 1.35 * LEAST_WIDTH * 40), (9000.0, 0.5, MOST_WIDTH * 40)):
            within = inside(replace(SLITS, growth=growth), u, v, away) > 0
            lengths = np.concatenate([runs(column) for column in within.T]) / 2
            assert len(lengths) > 1000
            # The sway stretches rows by less than a tenth.
            assert 0.8 * widest < lengths.max() <= 1.1 * widest + 0.5

    def test_gaps_taper_to_points(self) -> None:
        """Of a gap's columns the outermost are the thinnest."""
        u, v = grid(2000.0, 60.0, 0.5)
        within = inside(replace(SLITS, growth=0.1, share=0.4), u, v) > 0
        thick = within.sum(axis=0)
        ends = np.nonzero(np.diff((thick > 0).astype(int)))[0]
        assert len(ends) >= 2
        assert all(thick[each : each + 2].max() <= 4 < thick.max() for each in ends)

    def test_rows_never_meet(self) -> None:
        """The widest gaps everywhere: each column of 100 rows has shadow between any two of them."""
        slits = replace(SLITS, share=1.0, growth=1.0)
        v, u = np.mgrid[0.0:4000.0:0.5, 0.0:3000.0:101.0]
        within = inside(slits, u, v, 9000.0) > 0
        counts = [len(runs(column)) for column in within.T]
        assert min(counts) >= 90
        assert max(counts) <= 102


class TestClear:
    @given(st.floats(0.0, 100.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0))
    def test_near_the_feet_there_are_none(self, away: float, growth: float, share: float) -> None:
        slits = replace(SLITS, growth=growth, share=max(share, 0.01))
        assert (inside(slits, *grid(800.0, 160.0, 4.0), away) <= 0).all()

    def test_with_the_distance_they_get_wider(self) -> None:
        u, v = grid(3000.0, 800.0, 2.0)
        open_parts = [(inside(replace(SLITS, growth=0.05), u, v, away) > 0).mean() for away in (110, 130, 200, 350)]
        assert open_parts == sorted(open_parts)
        assert open_parts[0] < 0.2 * open_parts[-1]
        even = [(inside(SLITS, u, v, away) > 0).mean() for away in (150.0, 900.0)]
        assert even[0] == pytest.approx(even[1])


class TestMotion:
    WAVE = Wave(5.0, 40.0, 90.0, 3.0)

    @given(st.floats(-360.0, 360.0), st.integers(1, 999))
    def test_without_a_spacing_they_lie_on_the_crests(self, direction: float, seed: int) -> None:
        first = replace(self.WAVE, direction_deg=direction).varied(seed, 1)
        slits = replace(SLITS, spacing_px=0.0).upon(first, 5.0, 48)
        assert slits.spacing_px == first.wave.wavelength_px
        assert slits.direction_deg == first.wave.direction_deg
        # Rows begin where the phase is whole turns.
        place = slits.moved_px * np.array(slits.across_from_ground[1])
        psi = first.at(5.0).phase + np.array(first.k) @ place
        assert np.cos(psi) == pytest.approx(1.0, abs=1e-6)

    def test_a_spacing_of_their_own(self) -> None:
        slits = replace(SLITS, spacing_px=55.0).upon(self.WAVE.varied(0, 1), 0.0, 47)
        assert slits.spacing_px == 55.0
        assert slits.rows > 10_000

    @pytest.mark.parametrize("spacing", [0.0, 25.0, 70.0, 4000.0])
    @pytest.mark.parametrize("velocity", [5 * 40 / 48, -2 * 40 / 48])
    def test_they_loop_with_the_waves(self, spacing: float, velocity: float) -> None:
        first = replace(self.WAVE, velocity_px=velocity).varied(3, 1)
        start, half, end = (replace(SLITS, spacing_px=spacing).upon(first, frame, 48) for frame in (0.0, 24.0, 48.0))
        assert start.rows * start.spacing_px == pytest.approx(abs(first.wave.velocity_px) * 48)
        if spacing:
            assert start.rows == max(round(start.rows * start.spacing_px / spacing), 1)
        u, v = grid(900.0, 300.0, 3.0)
        assert inside(end, u, v) == pytest.approx(inside(start, u, v), abs=1e-6)
        assert np.abs(inside(half, u, v) - inside(start, u, v)).max() > 1

    def test_still_waves_never_come_to_the_same_row_again(self) -> None:
        assert replace(SLITS).upon(replace(self.WAVE, velocity_px=0.0).varied(0, 1), 7.0, 48).rows > 10_000

    def test_they_go_on_steadily_over_whole_spacings(self) -> None:
        u, v = grid(900.0, 300.0, 3.0)
        for whole in (-40.0, 0.0, 40.0, 1200.0):
            before, after = (inside(replace(SLITS, moved_px=whole + by), u, v) for by in (-1e-4, 1e-4))
            # The middle between two rows belongs to the one or the other.
            assert np.mean(np.abs(after - before) < 0.01) > 0.999

    def test_rows_go_where_waves_go(self) -> None:
        """A gap is found again where the crest has gone, up to its slow sway and breath."""
        u, v = grid(900.0, 300.0, 3.0)
        turned = replace(SLITS, direction_deg=30.0, moved_px=11.0)
        way = 4.0 * np.array(turned.across_from_ground[1])
        later = replace(turned, moved_px=15.0)
        followed = inside(later, u + way[0], v + way[1]) > 0
        before = inside(turned, u, v) > 0
        assert np.mean(followed != before) < 0.35 * np.mean((inside(later, u, v) > 0) != before)

    def test_no_two_rows_are_alike_and_a_seed_is_another_water(self) -> None:
        u, v = grid(6000.0, 20.0, 4.0)
        rows = [inside(SLITS, u, v + 40.0 * number) > 0 for number in range(12)]
        rows += [inside(replace(SLITS, seed=seed), u, v) > 0 for seed in (1, 2)]
        apart = [np.mean(a != b) for i, a in enumerate(rows) for b in rows[i + 1 :]]
        assert min(apart) > 0.02
        assert np.array_equal(inside(replace(SLITS, seed=2), u, v) > 0, rows[-1])


def test_rows_are_counted_from_where_they_began() -> None:
    slits = replace(SLITS, rows=7)
    assert [replace(slits, moved_px=40.0 * n + 3).first_row % 7 for n in range(3)] == [0, 6, 5]
    assert replace(slits, moved_px=50.0).moved_part == pytest.approx(0.25)
    assert slits.first_row > 0
    assert SLITS.across_from_ground[1] == pytest.approx((0.0, 1.0))
    assert replace(SLITS, direction_deg=180.0).across_from_ground[1] == pytest.approx((-1.0, 0.0))
