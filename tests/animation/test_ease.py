"""Eases by speed and influence."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kagezou.animation.ease import EASY, MIN_INFLUENCE, Ease, eased

values = st.floats(-1e4, 1e4)
spans = st.floats(1, 500)
influences = st.floats(0, 2)
eases = st.builds(Ease, st.floats(-100, 100), influences)
positions = st.floats(0, 1)


def brute_force(position: float, start: float, end: float, span: float, leaving: Ease, reaching: Ease) -> float:
    """The same curve by stepping along it finely and taking the nearest time."""
    x1, x2 = max(min(leaving.influence, 1), MIN_INFLUENCE), 1 - max(min(reaching.influence, 1), MIN_INFLUENCE)
    y1, y2 = start + leaving.speed * x1 * span, end - reaching.speed * (1 - x2) * span
    steps = 20000
    best = min(
        range(steps + 1),
        key=lambda i: abs(3 * (1 - i / steps) ** 2 * (i / steps) * x1 + 3 * (1 - i / steps) * (i / steps) ** 2 * x2
                          + (i / steps) ** 3 - position),
    ) / steps  # fmt: skip
    v = 1 - best
    return v**3 * start + 3 * v * v * best * y1 + 3 * v * best * best * y2 + best**3 * end


def test_golden_easy_ease() -> None:
    assert eased(0.5, 0.0, 100.0, 24.0, EASY, EASY) == pytest.approx(50.0, abs=1e-9)
    # x(u) = u for influences of a third, so the curve is 3u² − 2u³.
    assert eased(0.25, 0.0, 100.0, 24.0, EASY, EASY) == pytest.approx(15.625, abs=1e-9)
    assert eased(0.75, 0.0, 100.0, 24.0, EASY, EASY) == pytest.approx(84.375, abs=1e-9)


def test_golden_full_influence() -> None:
    # Both control points meet in time at the other key: x(u) = 3u(1−u)² + u³, y = 3u² − 2u³.
    # Time stands still at u = 1/2, where a double tells u apart only to its cube root.
    both = Ease(0.0, 1.0)
    assert eased(0.5, 0.0, 1.0, 10.0, both, both) == pytest.approx(0.5, abs=1e-4)
    assert eased(0.4375, 0.0, 1.0, 10.0, both, both) == pytest.approx(0.15625, abs=1e-6)


@given(positions, values, values, spans)
def test_without_eases_it_is_the_chord(position: float, start: float, end: float, span: float) -> None:
    chord = start + (end - start) * position
    assert eased(position, start, end, span, None, None) == pytest.approx(chord, rel=1e-9, abs=1e-6)
    slope = (end - start) / span
    both = Ease(slope, 0.7), Ease(slope, 0.2)
    assert eased(position, start, end, span, *both) == pytest.approx(chord, rel=1e-9, abs=1e-6)


@given(values, values, spans, eases, eases)
def test_it_starts_and_ends_at_the_keys(start: float, end: float, span: float, out: Ease, into: Ease) -> None:
    both = out, into
    # float64 knows the end of a curve only as well as its control points are large.
    room = 1e-9 * (1 + abs(start) + abs(end) + (abs(out.speed) + abs(into.speed)) * span)
    assert eased(0.0, start, end, span, *both) == pytest.approx(start, abs=room)
    assert eased(1.0, start, end, span, *both) == pytest.approx(end, abs=room)
    assert eased(-3.0, start, end, span, *both) == eased(0.0, start, end, span, *both)
    assert eased(4.0, start, end, span, *both) == eased(1.0, start, end, span, *both)


@given(positions, values, values, spans, influences, influences)
def test_at_rest_at_both_keys_it_stays_between_them(
    position: float, start: float, end: float, span: float, out: float, into: float
) -> None:
    value = eased(position, start, end, span, Ease(0.0, out), Ease(0.0, into))
    assert min(start, end) - 1e-6 <= value <= max(start, end) + 1e-6


@given(positions, positions, influences, influences)
def test_at_rest_at_both_keys_it_never_turns_back(a: float, b: float, out: float, into: float) -> None:
    low, high = sorted((a, b))
    eases = Ease(0.0, out), Ease(0.0, into)
    assert eased(low, 0.0, 1.0, 10.0, *eases) <= eased(high, 0.0, 1.0, 10.0, *eases) + 1e-9


def test_speed_may_overshoot() -> None:
    peak = max(eased(i / 50, 0.0, 10.0, 10.0, Ease(5.0, 0.5), EASY) for i in range(51))
    assert peak > 10.0
    assert min(eased(i / 50, 0.0, 10.0, 10.0, Ease(-5.0, 0.5), EASY) for i in range(51)) < 0.0


def test_the_speed_is_the_slope_at_the_key() -> None:
    step = 1e-4
    rise = eased(step, 0.0, 10.0, 10.0, Ease(3.0, 0.4), EASY)
    assert rise / (step * 10.0) == pytest.approx(3.0, rel=1e-3)
    drop = 10.0 - eased(1 - step, 0.0, 10.0, 10.0, EASY, Ease(2.0, 0.4))
    assert drop / (step * 10.0) == pytest.approx(2.0, rel=1e-3)


@pytest.mark.parametrize("position", [0.1, 0.37, 0.5, 0.81])
@pytest.mark.parametrize(
    ("out", "into"), [((2.0, 0.2), (-1.0, 0.9)), ((0.0, 0.0001), (0.0, 1.0)), ((4.0, 1.7), (0.0, 0.5))]
)
def test_against_stepping_along_the_curve(position: float, out: tuple[float, float], into: tuple[float, float]) -> None:
    eases = Ease(*out), Ease(*into)
    assert eased(position, 3.0, 17.0, 12.0, *eases) == pytest.approx(
        brute_force(position, 3.0, 17.0, 12.0, *eases), abs=0.01
    )
