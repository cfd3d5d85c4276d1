"""Polygons that cross themselves, taken apart into loops that do not."""

from typing import Final

import numpy as np

from kagezou.geometry.vectors import Matrix

_MAX_CORNERS: Final = 300
_MAX_LOOPS: Final = 100

_TRIANGLE: Final = 3


def simple_loops(ring: Matrix) -> tuple[Matrix, ...] | None:
    """Return the loops of a polygon, cut in two wherever it crosses itself; None for too many corners or crossings.

    Parameters
    ----------
    ring
        (N, 2 + K): places in its plane, and whatever else belongs to its corners, which is the mean of both sides
        where they cross.
    """
    if len(ring) > _MAX_CORNERS:
        return None
    waiting, done = [ring], list[Matrix]()
    while waiting:
        loop = waiting.pop()
        found = _first_crossing(loop[:, :2]) if len(loop) > _TRIANGLE else None
        if found is None:
            done.append(loop)
            continue
        if len(waiting) + len(done) + 2 > _MAX_LOOPS:
            return None
        i, j, at_i, at_j = found
        on_i = loop[i] + at_i * (loop[i + 1] - loop[i])
        on_j = loop[j] + at_j * (loop[(j + 1) % len(loop)] - loop[j])
        place = (on_i + on_j)[np.newaxis] / 2
        waiting += [np.concatenate([place, loop[i + 1 : j + 1]]), np.concatenate([loop[: i + 1], place, loop[j + 1 :]])]
    return tuple(loop for loop in done if len(loop) >= _TRIANGLE)


def _first_crossing(seen: Matrix) -> tuple[int, int, float, float] | None:
    """Return two sides of a polygon (N, 2) that cross within both, and where along each; the first pair there is."""
    along = np.roll(seen, -1, axis=0) - seen
    count = len(seen)
    for i in range(count - 2):
        # Neighbours share a corner.
        others = np.arange(i + 2, count if i else count - 1)
        between = seen[others] - seen[i]
        turn = along[i, 0] * along[others, 1] - along[i, 1] * along[others, 0]
        with np.errstate(all="ignore"):
            at_i = (between[:, 0] * along[others, 1] - between[:, 1] * along[others, 0]) / turn
            at_j = (between[:, 0] * along[i, 1] - between[:, 1] * along[i, 0]) / turn
            is_met = (at_i > 1e-9) & (at_i < 1 - 1e-9) & (at_j > 1e-9) & (at_j < 1 - 1e-9)
        if is_met.any():
            first = int(is_met.argmax())
            return i, int(others[first]), float(at_i[first]), float(at_j[first])
    return None


def loops_apart(ring: Matrix) -> tuple[Matrix, ...]:
    """Return the loops of a polygon (N, 2 + K), cut in two wherever two of its corners lie at one place."""
    waiting, done = [ring], list[Matrix]()
    while waiting:
        loop = waiting.pop()
        found = _first_pinch(loop[:, :2])
        if found is None:
            done.append(loop)
        else:
            i, j = found
            waiting += [loop[i:j], np.concatenate([loop[:i], loop[j:]])]
    return tuple(loop for loop in done if len(loop) >= _TRIANGLE)


def _first_pinch(seen: Matrix) -> tuple[int, int] | None:
    for i in range(len(seen) - 1):
        same = (seen[i + 1 :] == seen[i]).all(axis=1)
        if same.any():
            return i, i + 1 + int(same.argmax())
    return None
