"""Waves: their length, where they go, loops, seeds, and when they tear."""

from dataclasses import replace
from itertools import product
from math import cos, pi, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.geometry.waves import SEEDED_STRETCH, SEEDED_TURN_DEG, Ripple, Wave, tear_of

WAVES = st.builds(
    Wave,
    st.floats(0.0, 100.0),
    st.floats(4.0, 1000.0),
    st.floats(-360.0, 360.0),
    st.floats(-50.0, 50.0),
    st.tuples(*[st.floats(-3.0, 3.0)] * 4),
)
TURNS = np.linspace(0.0, 2 * pi, 721)


def moved(wave: Wave, psi: np.ndarray) -> np.ndarray:
    """Equation (4) letter by letter, (N, 2)."""
    a00, a01, a10, a11 = (wave.amplitude_px * each for each in wave.matrix)
    du, dv = np.cos(psi), np.sin(psi)
    return np.stack([a00 * du + a10 * dv, a01 * du + a11 * dv], axis=-1)


def phase_at(ripple: Ripple, u: float, v: float) -> float:
    return ripple.phase + ripple.k[0] * u + ripple.k[1] * v


class TestRipple:
    @given(WAVES, st.floats(0.0, 48.0))
    def test_a_crest_goes_where_it_is_told(self, wave: Wave, frame: float) -> None:
        start = wave.varied(0, 1)
        away = wave.velocity_px * frame
        angle = wave.direction_deg * pi / 180
        late = phase_at(start.at(frame), away * cos(angle), away * sin(angle))
        assert cos(late - phase_at(start, 0.0, 0.0)) == pytest.approx(1.0, abs=1e-9)

    @given(WAVES)
    def test_a_wavelength_is_one_turn(self, wave: Wave) -> None:
        ripple = wave.varied(0, 1)
        angle = wave.direction_deg * pi / 180
        along = phase_at(ripple, wave.wavelength_px * cos(angle), wave.wavelength_px * sin(angle))
        assert along - ripple.phase == pytest.approx(-2 * pi)

    @given(WAVES, st.integers(1, 200), st.integers(0, 5))
    def test_a_looping_wave_comes_back(self, wave: Wave, frames: int, seed: int) -> None:
        ripple = wave.looping(frames).varied(seed, 1)
        assert cos(ripple.at(frames).phase - ripple.phase) == pytest.approx(1.0, abs=1e-6)

    def test_looping_changes_little(self) -> None:
        assert Wave(5.0, 60.0, 90.0, 3.0).looping(48).velocity_px == pytest.approx(2.5)
        assert Wave(5.0, 60.0, 90.0, 2.5).looping(48).velocity_px == 2.5


class TestSeed:
    @given(WAVES, st.integers(1, 999999))
    def test_the_same_seed_is_the_same_wave(self, wave: Wave, seed: int) -> None:
        ripple = wave.varied(seed, 1)
        assert ripple == wave.varied(seed, 1)
        assert ripple != wave.varied(seed, 2)
        assert ripple.wave.wavelength_px / wave.wavelength_px * (1 + 1e-9) >= 1 / SEEDED_STRETCH
        assert ripple.wave.wavelength_px / wave.wavelength_px <= SEEDED_STRETCH * (1 + 1e-9)
        assert abs(ripple.wave.direction_deg - wave.direction_deg) <= SEEDED_TURN_DEG + 1e-9

    def test_no_seed_changes_nothing(self) -> None:
        wave = Wave(5.0, 60.0, 90.0, 3.0)
        assert wave.varied(0, 2) == Ripple(wave, 0.0)

    def test_seeds_spread_evenly(self) -> None:
        phases = [Wave(5.0, 60.0, 90.0, 3.0).varied(seed, 1).phase / (2 * pi) for seed in range(1, 401)]
        assert sum(phases) / 400 == pytest.approx(0.5, abs=0.05)
        assert len({round(each, 6) for each in phases}) == 400


class TestMatrix:
    @given(WAVES)
    def test_no_place_is_moved_beyond_the_reach(self, wave: Wave) -> None:
        far = float(np.hypot(*moved(wave, TURNS).T).max())
        assert far <= wave.reach_px * (1 + 1e-9) + 1e-9
        assert far >= wave.reach_px * 0.9999 - 1e-9

    @given(WAVES)
    def test_the_outline_folds_where_the_tear_number_is_beyond_one(self, wave: Wave) -> None:
        """The place that is read goes backward somewhere along a turn, exactly where the tear number is over 1."""
        (k_u, k_v), step = wave.k, 1e-6
        rate = (moved(wave, TURNS + step) - moved(wave, TURNS - step)) / (2 * step)
        least = float((1 + rate @ np.array([k_u, k_v])).min())
        assert least == pytest.approx(1 - wave.tear, abs=1e-3 + 1e-4 * wave.tear)

    def test_the_unit_matrix_is_what_waves_are_without_one(self) -> None:
        wave = Wave(7.3, 60.0, 33.0, 1.0)
        assert wave == replace(wave, matrix=(1.0, 0.0, 0.0, 1.0))
        assert wave.reach_px == 7.3

    @pytest.mark.parametrize(("turned", "flat"), list(product((0.0, 90.0), (0.0, 1.0))))
    def test_what_moves_along_the_crests_tears_nothing(self, turned: float, flat: float) -> None:
        sideways = Wave(30.0, 60.0, turned, 0.0, (1.0 - flat, 0.0, 0.0, flat))
        assert sideways.tear == pytest.approx(pi if (turned == 90.0) == (flat == 1.0) else 0.0, abs=1e-9)


def test_the_tear_number_is_amplitude_times_wave_number() -> None:
    calm, torn = Wave(5.0, 100.0, 90.0, 0.0), Wave(30.0, 60.0, 0.0, 0.0)
    assert calm.tear == pytest.approx(0.314159, rel=1e-5)
    assert torn.tear == pytest.approx(pi)
    assert tear_of((calm, torn)) == pytest.approx(calm.tear + torn.tear)
