"""Waves on water: how far a shadow is moved at each point of the ground (paper 3.6.2, spec 4)."""

from dataclasses import dataclass, replace
from math import cos, exp, hypot, log, pi, radians, sin

SEEDED_TURN_DEG = 25.0
"""A seed turns the direction by this much at most."""

SEEDED_STRETCH = 4 / 3
"""A seed makes the waves longer or shorter by this factor at most."""


@dataclass(frozen=True, slots=True)
class Wave:
    """One set of waves as a person sets it.

    In the letters of the specification (a, b) is the unit vector against the direction, λ half the wavelength, vel the
    velocity and A the amplitude times the matrix.

    Parameters
    ----------
    amplitude_px
        How far a point is moved, times the matrix.
    wavelength_px
        From crest to crest, over 0.
    direction_deg
        Where the crests go on the ground: 0 along u, 90 along v, toward the viewer.
    velocity_px
        How far they go in a frame.
    matrix
        (A00, A01, A10, A11) as parts of the amplitude: A00 moves along u and A11 along v, A10 and A01 shear.
    """

    amplitude_px: float
    wavelength_px: float
    direction_deg: float
    velocity_px: float
    matrix: tuple[float, float, float, float] = (1.0, 0.0, 0.0, 1.0)

    @property
    def tear(self) -> float:
        """|Aᵀk|: under 1 the outline wobbles, beyond 1 it is torn into stripes.

        The place that is read changes with the place by 1 + D·k, D a turn of (cos, sin); its least is 1 - |Aᵀk|.
        """
        (k_u, k_v), (a00, a01, a10, a11) = self.k, self.matrix
        return abs(self.amplitude_px) * hypot(a00 * k_u + a01 * k_v, a10 * k_u + a11 * k_v)

    @property
    def k(self) -> tuple[float, float]:
        """The change of ψ along u and v, radians a px."""
        turn, angle = 2 * pi / self.wavelength_px, radians(self.direction_deg)
        return (-turn * cos(angle), -turn * sin(angle))

    @property
    def reach_px(self) -> float:
        """How far a point is moved at most: the larger singular value of A."""
        a00, a01, a10, a11 = self.matrix
        return abs(self.amplitude_px) * (hypot(a00 + a11, a01 - a10) + hypot(a00 - a11, a01 + a10)) / 2

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
    """A set of waves at one moment: ψ = k·(u, v) + phase moves (u, v) by D′ (paper equation 4).

    D′ = amplitude · (A00·cos ψ + A10·sin ψ, A01·cos ψ + A11·sin ψ).
    """

    wave: Wave
    phase: float

    def at(self, frame: float) -> "Ripple":
        """Return the waves ``frame`` frames later."""
        turn = 2 * pi * self.wave.velocity_px * frame / self.wave.wavelength_px
        return replace(self, phase=(self.phase + turn) % (2 * pi))

    @property
    def k(self) -> tuple[float, float]:
        """The change of ψ along u and v, radians a px."""
        return self.wave.k


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
