"""Every hand-over against the picture: layers laid as each program lays them, over what may come together in a cut."""

from itertools import combinations
from pathlib import Path

import pytest

from tests.effort import tries
from tests.export.hand_over_cuts import EVERY, FRAMES, Combination, combined
from tests.export.hand_over_pictures import HAND_OVERS, ROUNDED, levels_between, picture


def covering(every: tuple[Combination, ...]) -> tuple[Combination, ...]:
    """Return combinations among which each choice comes at least once, or, where all is tried, any two together."""

    def together(each: Combination) -> set[tuple[tuple[int, str], ...]]:
        return set(combinations(enumerate(each.parts), tries(1, 2)))

    missing = {some for each in every for some in together(each)}
    found = []
    while missing:
        best = max(every, key=lambda each: len(together(each) & missing))
        missing -= together(best)
        found.append(best)
    return tuple(found)


@pytest.mark.parametrize("wanted", covering(EVERY), ids=str)
def test_what_is_seen_goes_over(wanted: Combination, tmp_path: Path) -> None:
    document = combined(wanted, tmp_path)
    seen = picture(document, tmp_path / "picture")
    for name, make in HAND_OVERS.items():
        made = make(document, tmp_path / name)
        most = max(levels_between(made(frame), seen(frame)) for frame in range(1, FRAMES + 1))
        # A program that rounds to 8 bit after each layer adds to what ours has rounded by then.
        assert most <= (2 if name in ROUNDED else 1), f"{name}: {most} levels"
