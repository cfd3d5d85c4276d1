"""Every hand-over against the picture: layers laid as each program lays them, over what may come together in a cut."""

from pathlib import Path

import pytest

from tests.export.hand_over_cuts import EVERY, FRAMES, Combination, combined
from tests.export.hand_over_pictures import HAND_OVERS, ROUNDED, levels_between, picture


def covering(every: tuple[Combination, ...]) -> tuple[Combination, ...]:
    """Return combinations among which any two choices come together at least once."""

    def pairs(each: Combination) -> set[tuple[tuple[int, str], tuple[int, str]]]:
        parts = list(enumerate(each.parts))
        return {(one, other) for one in parts for other in parts if one[0] < other[0]}

    missing = {pair for each in every for pair in pairs(each)}
    found = []
    while missing:
        best = max(every, key=lambda each: len(pairs(each) & missing))
        missing -= pairs(best)
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
