"""When the drawings of a retake are exposed, and where the frames of before went.

Where the numbers of the drawings said on which frames they are seen, those of the new ones do. Where each drawing was
exposed once, one after the other, the new ones are too: what was held longer still is, and what is new is held as long
as the one before it. Any other timing, as that of a sheet, stays on its frames.
"""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from kagezou.document.model import Cels, Exposure
from kagezou.io.names.runs import number_in


@dataclass(frozen=True, slots=True)
class Retimed:
    """The exposures of the new drawings.

    Parameters
    ----------
    exposures
        What is seen when.
    length_frames
        The last frame that a drawing needs, each as long as it is held.
    moves
        Frames of before and of now, upward: from each on, frames went to the other. Empty where all stay.
    gone
        Frames of before on which a drawing began that is gone.
    unseen
        New drawings that are exposed nowhere.
    closes_up
        Whether what is behind a drawing that is gone comes forward; else the one before is held.
    """

    exposures: tuple[Exposure, ...]
    length_frames: int
    moves: tuple[tuple[int, int], ...] = ()
    gone: tuple[int, ...] = ()
    unseen: tuple[int, ...] = ()
    closes_up: bool = False

    def stays(self, frame: int) -> bool:
        """Return whether what was seen on a frame of before is still there."""
        after = bisect_right(self.moves, frame, key=lambda move: move[0])
        return not after or self.moves[after - 1][0] not in self.gone

    def moved(self, frame: int) -> int:
        """Return where a frame of before went."""
        after = bisect_right(self.moves, frame, key=lambda move: move[0])
        if not after:
            return frame
        old, new = self.moves[after - 1]
        away = frame - old
        if after < len(self.moves):
            # A drawing that is held shorter now ends before what was set on its last frames.
            away = min(away, max(self.moves[after][1] - new - 1, 0))
        return new + away


def retimed(before: Cels, after: Cels, became: Mapping[int, int], length_frames: int) -> Retimed:
    """Return the exposures of a retake.

    Parameters
    ----------
    before
        The drawings there were, and their exposures.
    after
        The drawings there are now, exposed as their files say, which counts where none was known again.
    became
        Which of before is which of now; those that are missing are gone.
    length_frames
        The length of the cut, to which the last drawing is held.
    """
    count = len(after.drawings)
    if _is_by_numbers(before):
        return _by_numbers(before, after, became)
    if _is_plain(before):
        return _one_after_the_other(before, count, became, length_frames)
    if not became:
        last = max((each.frame for each in after.exposures), default=1)
        return Retimed(after.exposures, last, (), tuple(each.frame for each in before.exposures))
    exposures: list[Exposure] = []
    gone: list[int] = []
    for each in before.exposures:
        drawing = None if each.drawing is None else became.get(each.drawing)
        if each.drawing is not None and drawing is None:
            gone.append(each.frame)
            if exposures:
                # The one before is held.
                continue
        if not exposures or exposures[-1].drawing != drawing:
            exposures.append(Exposure(each.frame, drawing))
    seen = {each.drawing for each in exposures}
    unseen = tuple(number for number in range(count) if number not in seen)
    last = max((each.frame for each in exposures), default=1)
    return Retimed(tuple(exposures), last, (), tuple(gone), unseen)


def _is_by_numbers(cels: Cels) -> bool:
    """Return whether drawings whose numbers have gaps are exposed on the frames of their numbers."""
    numbers = [number_in(drawing.name) for drawing in cels.drawings]
    if not _is_plain(cels) or None in numbers or not numbers:
        return False
    ways = [(number[0], each.frame) for number, each in zip(numbers, cels.exposures, strict=True) if number is not None]
    first = ways[0]
    is_on_frames = all(number - first[0] == frame - first[1] for number, frame in ways)
    return is_on_frames and ways[-1][0] - first[0] > len(ways) - 1


def _by_numbers(before: Cels, after: Cels, became: Mapping[int, int]) -> Retimed:
    away = before.exposures[0].frame - min((each.frame for each in after.exposures), default=1)
    exposures = [Exposure(each.frame + away, each.drawing) for each in after.exposures]
    gone = tuple(each.frame for each in before.exposures if each.drawing is not None and each.drawing not in became)
    seen = {each.drawing for each in exposures}
    unseen = tuple(number for number in range(len(after.drawings)) if number not in seen)
    last = max((each.frame for each in exposures), default=1)
    return Retimed(tuple(exposures), last, _moves(before.exposures, exposures, became), gone, unseen)


def _is_plain(cels: Cels) -> bool:
    shown = [each.drawing for each in cels.exposures]
    return shown == list(range(len(cels.drawings)))


def _one_after_the_other(before: Cels, count: int, became: Mapping[int, int], length_frames: int) -> Retimed:
    starts = [each.frame for each in before.exposures]
    ends = [*starts, length_frames + 1][1:]
    held = [max(end - start, 1) for start, end in zip(starts, ends, strict=True)]
    if len(held) > 1:
        # To the end of the cut the last one is only held on.
        held[-1] = min(held[-1], held[-2])
    came_from = {new: old for old, new in became.items()}
    frame = starts[0] if starts else 1
    exposures: list[Exposure] = []
    lasting = held[0] if held else 1
    for number in range(count):
        lasting = held[came_from[number]] if number in came_from else lasting
        exposures.append(Exposure(frame, number))
        frame += lasting
    moves = _moves(before.exposures, exposures, became)
    gone = tuple(each.frame for each in before.exposures if each.drawing is not None and each.drawing not in became)
    return Retimed(tuple(exposures), frame - 1, moves, gone, closes_up=True)


def _moves(
    before: Sequence[Exposure], after: Sequence[Exposure], became: Mapping[int, int]
) -> tuple[tuple[int, int], ...]:
    """Return where frames went, by the drawings that were seen on them; those of a drawing that is gone go to the next.

    Empty where none moves, and where drawings changed places, so that no frame comes before one that was before it.
    """
    starts = {each.drawing: each.frame for each in after}
    moves: list[tuple[int, int]] = []
    waiting: list[int] = []
    for each in before:
        new = None if each.drawing is None else became.get(each.drawing)
        if new is None:
            waiting.append(each.frame)
            continue
        moves += [(frame, starts[new]) for frame in waiting]
        waiting = []
        moves.append((each.frame, starts[new]))
    if waiting and moves:
        moves += [(frame, moves[-1][1]) for frame in waiting]
    news = [new for _, new in moves]
    if news != sorted(news) or all(old == new for old, new in moves):
        return ()
    return tuple(moves)
