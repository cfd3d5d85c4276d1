"""Heights of all bodies over a plane at once, digit for digit those of each alone."""

import pytest

from kagezou.geometry.ground import ground_plane
from kagezou.geometry.sets.bodies import Body
from kagezou.geometry.sets.extents import Extents
from kagezou.geometry.sets.measures import Measures, PieceKind
from kagezou.geometry.sets.regions import heights_over
from kagezou.geometry.sets.shapes import bodies_of, stand_on

GROUND = ground_plane((400.0, 500.0), 7.0, 63.0)


def bodies(*kinds: str) -> tuple[Body, ...]:
    made: list[Body] = []
    for number, kind in enumerate(kinds):
        stand = stand_on(GROUND, (100.0 * number, 500.0 - 31 * number, -17.0 * number), 23.0 * number)
        made += bodies_of(stand, Measures(PieceKind(kind), 70.0, 40.0, 33.0, 11.0, 3))
    return tuple(made)


@pytest.mark.parametrize(
    "kinds", [(), ("box",), ("sphere", "cylinder"), ("steps", "sphere", "wall", "cylinder", "ramp", "box")]
)
def test_each_body_reaches_as_far_as_alone(kinds: tuple[str, ...]) -> None:
    every = bodies(*kinds)
    found = Extents.of(every)
    for plane in (GROUND.equation, (0.6, 0.0, 0.8, -3.25), (0.0, -1.0, 0.0, 1e3)):
        assert found.over(plane) == tuple(heights_over(plane, body) for body in every)
