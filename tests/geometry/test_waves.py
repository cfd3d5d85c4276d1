"""Waves: their length, where they go, loops, seeds, and when they tear."""

from math import cos, pi, sin

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
)


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


def test_the_tear_number_is_amplitude_times_wave_number() -> None:
    calm, torn = Wave(5.0, 100.0, 90.0, 0.0), Wave(30.0, 60.0, 0.0, 0.0)
    assert calm.tear == pytest.approx(0.314159, rel=1e-5)
    assert torn.tear == pytest.approx(pi)
    assert tear_of((calm, torn)) == pytest.approx(calm.tear + torn.tear)
