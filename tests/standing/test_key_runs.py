"""Between which runs of frames feet are compared."""

from kagezou.standing.foot import Verdict
from kagezou.standing.key_runs import key_runs
from kagezou.standing.seen import Seen, SeenFoot


def _moved(*drawings: int | None) -> list[Seen]:
    return [Seen(frame, 100.0, (SeenFoot(0, (float(frame), 0.0)),), drawing) for frame, drawing in enumerate(drawings)]


def test_each_drawing_has_a_key() -> None:
    assert key_runs(_moved(1, 1, 2, 2, 1, 1)) == ([0, 2, 4], [0, 0, 1, 1, 2, 2])


def test_runs_without_drawings_are_keys() -> None:
    assert key_runs(_moved(None, None, 2)) == ([0, 1, 2], [0, 1, 2])
    assert key_runs(_moved(1)) == ([0], [0])


def test_a_drawing_that_is_moved_for_long_has_several() -> None:
    assert key_runs(_moved(1, 1, 2, 2, 2, 2, 2, 3, 3, 4)) == ([0, 2, 4, 6, 7, 9], [0, 0, 1, 1, 2, 2, 3, 4, 4, 5])
    assert key_runs(_moved(1, 1, 1, 1)) == ([0, 1, 2, 3], [0, 1, 2, 3])


def test_a_drawing_that_is_moved_up_has_a_key_wherever_it_rose() -> None:
    rows = (50.0, 50.0, 49.5, 48.0, 48.0, 40.0)
    rising = [Seen(frame, 100.0, (SeenFoot(0, (0.0, row)),), frame // 6) for frame, row in enumerate(rows)]
    after = [Seen(6, 100.0, (), 1), Seen(18, 100.0, (), 2)]
    assert key_runs([*rising, *after])[0] == [0, 3, 5, 6, 7]


def test_a_verdict_of_its_own_makes_a_key() -> None:
    first, second = _moved(1, 1)
    pinned = Seen(1, 100.0, (SeenFoot(0, (1.0, 0.0), Verdict.LIFTED),), 1)
    assert not first.is_moved(pinned)
    assert key_runs([first, pinned]) == ([0, 1], [0, 1])
    assert key_runs([*_moved(2, 2), Seen(2, 100.0, second.feet, 2)])[0] == [0, 1, 2]
