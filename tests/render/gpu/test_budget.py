"""What is kept by name stays within its budget, and what may be in use stays whatever it takes."""

from dataclasses import dataclass

import pytest

from kagezou.render.gpu.budget import Budget


@dataclass
class Thing:
    nbytes: int
    is_closed: bool = False

    def close(self) -> None:
        assert not self.is_closed, "given back twice"
        self.is_closed = True


def kept_or_new(nbytes: int, known: Thing | None) -> Thing:
    return known or Thing(nbytes)


def put(budget: Budget[str, Thing], name: str, nbytes: int = 10) -> Thing:
    return budget.latest(name, lambda known: kept_or_new(nbytes, known))


def test_the_least_lately_used_go_first() -> None:
    budget: Budget[str, Thing] = Budget(30, spared=1)
    first = [put(budget, name) for name in "abc"]
    assert put(budget, "a") is first[0]
    put(budget, "d")
    put(budget, "e")
    assert budget.names == ("c", "a", "d", "e")
    assert first[1].is_closed
    assert budget.nbytes <= 30 + 10


def test_the_latest_are_spared_whatever_they_take() -> None:
    budget: Budget[str, Thing] = Budget(1, spared=2)
    a, b, c = (put(budget, name, 100) for name in "abc")
    assert (a.is_closed, b.is_closed, c.is_closed) == (False, False, False)
    put(budget, "d")
    assert (a.is_closed, b.is_closed, c.is_closed) == (True, False, False)


def test_what_has_grown_counts() -> None:
    budget: Budget[str, Thing] = Budget(30, spared=1)
    a, _ = put(budget, "a"), put(budget, "b")
    a.nbytes = 25
    put(budget, "b")
    assert a.is_closed


def test_what_cannot_be_made_leaves_nothing_behind() -> None:
    budget: Budget[str, Thing] = Budget(30)
    put(budget, "a")

    def refuse(known: Thing | None) -> Thing:
        assert known is not None
        known.close()
        raise MemoryError

    with pytest.raises(MemoryError):
        budget.latest("a", refuse)
    assert budget.names == ()
    budget.close()


def test_all_is_given_back_at_the_end() -> None:
    budget: Budget[str, Thing] = Budget(30)
    things = [put(budget, name) for name in "ab"]
    budget.forget(["a"])
    budget.close()
    assert all(each.is_closed for each in things)
    assert budget.nbytes == 0
