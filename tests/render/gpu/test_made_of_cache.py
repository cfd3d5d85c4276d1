import gc
import weakref
from dataclasses import dataclass

from kagezou.render.gpu.made_of_cache import MadeOfCache


class Source:
    """Something decoded."""


@dataclass
class Made:
    """Something on the graphics card."""

    nbytes: int = 10
    closed: bool = False

    def close(self) -> None:
        assert not self.closed
        self.closed = True


def test_what_is_there_is_not_made_again() -> None:
    shelf: MadeOfCache[Made] = MadeOfCache(100)
    source = Source()
    first = shelf.made_of(source, Made)
    assert shelf.made_of(source, Made) is first
    assert shelf.made_of(Source(), Made) is not first


def test_the_least_recently_used_goes_first() -> None:
    shelf: MadeOfCache[Made] = MadeOfCache(20)
    sources = [Source() for _ in range(3)]
    made = [shelf.made_of(source, Made) for source in sources[:2]]
    shelf.made_of(sources[0], Made)
    shelf.made_of(sources[2], Made)
    assert [each.closed for each in made] == [False, True]


def test_one_thing_over_the_budget_is_still_kept_while_it_is_used() -> None:
    shelf: MadeOfCache[Made] = MadeOfCache(5)
    source = Source()
    made = shelf.made_of(source, Made)
    assert not made.closed
    assert shelf.made_of(source, Made) is made


def test_a_source_is_not_kept_alive_and_what_was_made_of_it_goes() -> None:
    shelf: MadeOfCache[Made] = MadeOfCache(1000)
    source = Source()
    gone = weakref.ref(source)
    made = shelf.made_of(source, Made)
    del source
    gc.collect()
    assert gone() is None
    other = Source()
    assert shelf.made_of(other, Made) is not made
    assert made.closed


def test_closing_gives_everything_back() -> None:
    shelf: MadeOfCache[Made] = MadeOfCache(1000)
    sources = [Source(), Source()]
    made = [shelf.made_of(source, Made) for source in sources]
    shelf.close()
    assert all(each.closed for each in made)
