"""Eases kept as speed and influence, as After Effects keeps them, and the unit-square bezier they stand for."""

from dataclasses import dataclass

MIN_INFLUENCE = 0.001
"""The smallest influence After Effects accepts (0.1 %)."""


@dataclass(frozen=True, slots=True)
class Ease:
    """How a curve leaves or reaches a key.

    Parameters
    ----------
    speed
        Rate of change at the key, in value units per frame.
    influence
        How far the ease reaches toward the other key, as a part of the time between the two, 0.001 to 1.
    """

    speed: float = 0.0
    influence: float = 1 / 3


EASY = Ease()
"""Both animators' standard: at rest at the key, with a third of influence."""


def eased(
    position: float, start: float, end: float, span_frames: float, leaving: Ease | None, reaching: Ease | None
) -> float:
    """Return the value between two keys of one component.

    The curve is the cubic bezier through (0, start), (io·T, start + so·io·T), (T − ii·T, end − si·ii·T), (T, end)
    with the speeds s and influences i of the two eases and T = ``span_frames``. A missing ease lies on the chord.

    Parameters
    ----------
    position
        0 at the first key, 1 at the second.
    start, end
        The values at the keys.
    span_frames
        The time between the keys.
    leaving, reaching
        The ease out of the first key and into the second.
    """
    slope = (end - start) / span_frames
    out = leaving or Ease(slope)
    into = reaching or Ease(slope)
    reach_out = min(max(out.influence, MIN_INFLUENCE), 1.0)
    reach_in = min(max(into.influence, MIN_INFLUENCE), 1.0)
    u = _parameter_at(min(max(position, 0.0), 1.0), reach_out, 1 - reach_in)
    first = start + out.speed * reach_out * span_frames
    second = end - into.speed * reach_in * span_frames
    return _bezier(u, start, first, second, end)


def _bezier(u: float, p0: float, p1: float, p2: float, p3: float) -> float:
    v = 1 - u
    return v * v * v * p0 + 3 * v * v * u * p1 + 3 * v * u * u * p2 + u * u * u * p3


def _parameter_at(x: float, x1: float, x2: float) -> float:
    """Return u with B_x(u) = x for control abscissae 0, x1, x2, 1, all within 0..1.

    B_x never falls there, so bisection always finds it; 60 halvings exhaust a double.
    """
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        if _bezier(middle, 0.0, x1, x2, 1.0) < x:
            low = middle
        else:
            high = middle
    return (low + high) / 2
