"""Waves on water: how far a shadow is moved at each point of the ground (paper 3.6.2, spec 4)."""

from dataclasses import dataclass, replace
from math import cos, exp, log, pi, radians, sin

SEEDED_TURN_DEG = 25.0
"""A seed turns the direction by this much at most."""

SEEDED_STRETCH = 4 / 3
"""A seed makes the waves longer or shorter by this factor at most."""


@dataclass(frozen=True, slots=True)
class Wave:
    """One set of waves as a person sets it.

    In the letters of the specification (a, b) is the unit vector against the direction, λ half the wavelength, vel the
    velocity and A the amplitude times the unit matrix.

    Parameters
    ----------
    amplitude_px
        How far a point is moved.
    wavelength_px
        From crest to crest, over 0.
    direction_deg
        Where the crests go on the ground: 0 along u, 90 along v, toward the viewer.
    velocity_px
        How far they go in a frame.
    """

    amplitude_px: float
    wavelength_px: float
    direction_deg: float
    velocity_px: float

    @property
    def tear(self) -> float:
        """|Aᵀk|: under 1 the outline wobbles, beyond 1 it is torn into stripes."""
        return 2 * pi * abs(self.amplitude_px) / self.wavelength_px

    def varied(self, seed: int, number: int) -> "Ripple":
        """Return the waves of the first moment: set ``number`` as a seed varies it; seed 0 leaves it as it is.

        The number of crests that pass in a frame stays, so that a loop stays a loop.
        """
        if seed == 0:
            return Ripple(self, 0.0)
        first, second, third = (_chance(seed, number, each) for each in range(3))
        stretch = exp((2 * second - 1) * log(SEEDED_STRETCH))
        changed = replace(
            self,
            wavelength_px=self.wavelength_px * stretch,
            velocity_px=self.velocity_px * stretch,
            direction_deg=self.direction_deg + (2 * third - 1) * SEEDED_TURN_DEG,
        )
        return Ripple(changed, 2 * pi * first)

    def looping(self, frames: int) -> "Wave":
        """Return the waves with the nearest velocity at which they come back after ``frames`` (spec 4)."""
        crests = round(self.velocity_px * frames / self.wavelength_px)
        return replace(self, velocity_px=crests * self.wavelength_px / frames)


@dataclass(frozen=True, slots=True)
class Ripple:
    """A set of waves at one moment: D = A·(cos ψ, sin ψ), ψ = k·(u, v) + phase."""

    wave: Wave
    phase: float

    def at(self, frame: float) -> "Ripple":
        """Return the waves ``frame`` frames later."""
        turn = 2 * pi * self.wave.velocity_px * frame / self.wave.wavelength_px
        return replace(self, phase=(self.phase + turn) % (2 * pi))

    @property
    def k(self) -> tuple[float, float]:
        """The change of ψ along u and v, radians a px."""
        turn, angle = 2 * pi / self.wave.wavelength_px, radians(self.wave.direction_deg)
        return (-turn * cos(angle), -turn * sin(angle))


def tear_of(waves: tuple[Wave, ...]) -> float:
    """Return the tear number of several sets: under 1 nothing is torn."""
    return sum(wave.tear for wave in waves)


def _chance(*numbers: int) -> float:
    """Return a number of [0, 1) that depends on nothing but the given ones (splitmix64)."""
    state = 0
    for number in numbers:
        state = (state + number + 1) * 0x9E3779B97F4A7C15 % 2**64
        state = (state ^ (state >> 30)) * 0xBF58476D1CE4E5B9 % 2**64
        state = (state ^ (state >> 27)) * 0x94D049BB133111EB % 2**64
        state ^= state >> 31
    return state / 2**64
