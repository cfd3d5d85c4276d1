"""Keys as rows of a table, and as text with tabs that spreadsheets take and give."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from kagezou.animation.ease import EASY, MIN_INFLUENCE, Ease
from kagezou.animation.track import Interpolation, Key, Track, components_of, rebuilt
from kagezou.document.address import Address, track_of
from kagezou.document.edits import set_track
from kagezou.document.frame_numbers import frame_of, number_of
from kagezou.document.model import Canvas, Document
from kagezou.document.typed_number import evaluate
from kagezou.errors import UsageProblem
from kagezou.message import Message

HEADINGS = ("frame", "component", "value", "goes on", "speed in", "influence in %", "speed out", "influence out %")


_NUMBERS = (0, 2, 4, 5, 6, 7)
_INFLUENCES = (5, 7)
_IN_UNITS = (2, 4, 6)
"""Columns of the table; the last are in the unit of the property."""

_PER_CENT = 100.0

_MOST = 1e12
"""Comparing with it also keeps out what is no number at all."""


@dataclass(frozen=True, slots=True)
class KeyRow:
    """One component of one key; speeds in units a frame, influences in per cent."""

    frame: int
    component: int
    value: float
    interpolation: Interpolation
    ease_in: Ease
    ease_out: Ease

    @property
    def cells(self) -> tuple[str, ...]:
        """What the table shows, rounded to what is of use to the eye."""
        return self.cells_in(1.0)

    def cells_in(self, factor: float) -> tuple[str, ...]:
        """Return the same, value and speeds in another unit: times a factor."""
        return self._written(_rounded, factor)

    @property
    def exact_cells(self) -> tuple[str, ...]:
        """The same to the last bit, for text that comes back."""
        return self._written(repr)

    def _written(self, words_of: Callable[[float], str], factor: float = 1.0) -> tuple[str, ...]:
        into, out = self.ease_in, self.ease_out
        speeds = (into.speed * factor, out.speed * factor)
        numbers = (self.value * factor, speeds[0], into.influence * 100, speeds[1], out.influence * 100)
        value, *eases = (words_of(number) for number in numbers)
        return (str(self.frame), str(self.component + 1), value, self.interpolation.value, *eases)


def rows_of(document: Document, address: Address) -> tuple[KeyRow, ...]:
    """Return the rows of a property's keys."""
    rows = []
    for key in track_of(document, address).keys:
        for component, value in enumerate(components_of(key.value) or ()):
            eases = (_at(key.ease_in, component), _at(key.ease_out, component))
            rows.append(KeyRow(key.frame, component, value, key.interpolation, *eases))
    return tuple(rows)


def with_cell(
    document: Document, address: Address, row: KeyRow, column: int, text: str, factor: float = 1.0
) -> Document:
    """Return the document with one cell of the table changed; values and speeds were typed times a factor.

    Raises
    ------
    UsageProblem
        The text is not what the column holds.
    """
    cells = list(row.cells)
    cells[column] = _calculated(row, column, text, factor)
    changed = parse_row(cells)
    if changed.component != row.component:
        raise UsageProblem(Message("a key's component cannot be changed"))
    track = track_of(document, address)
    key = track.key_at(row.frame)
    if key is None:
        return document
    # Only the number that was typed is taken: the others are shown rounded.
    match column:
        case 0:
            new = replace(key, frame=changed.frame)
            return set_track(document, address, track.without_key(key.frame).with_key(new))
        case 2:
            parts = list(components_of(key.value) or ())
            parts[row.component] = changed.value
            new = replace(key, value=address.property.canonical(rebuilt(key.value, tuple(parts))))
        case 3:
            new = replace(key, interpolation=changed.interpolation)
        case _:
            new = _with_eases(key, row.component, _typed(row, changed, column))
    return set_track(document, address, track.with_key(new))


def in_frames(canvas: Canvas, text: str) -> str:
    """Return a typed frame, counted from the first one of the cut, counted from 1; other text as it is."""
    typed = text.strip()
    return str(frame_of(canvas, int(typed))) if typed.removeprefix("-").isdecimal() else text


def text_of(rows: tuple[KeyRow, ...], canvas: Canvas) -> str:
    """Return rows as lines with tabs, with a line of headings; frames count from the first one of the cut."""
    numbered = (replace(row, frame=number_of(canvas, row.frame)) for row in rows)
    return "\n".join("\t".join(cells) for cells in (HEADINGS, *(row.exact_cells for row in numbered))) + "\n"


def pasted(document: Document, address: Address, text: str) -> Document:
    """Return the document with keys from lines with tabs, as `text_of` writes them; keys on their frames go.

    Raises
    ------
    UsageProblem
        A line is no key, or a frame lacks a component.
    """
    lines = [line.split("\t") for line in text.splitlines() if line.strip()]
    if lines and lines[0][: len(HEADINGS)] == list(HEADINGS)[: len(lines[0])]:
        lines = lines[1:]
    found: dict[int, dict[int, KeyRow]] = {}
    for cells in lines:
        row = parse_row([in_frames(document.canvas, cells[0]), *cells[1:]])
        found.setdefault(row.frame, {})[row.component] = row
    track = track_of(document, address)
    keys = [_key(address, track, frame, parts) for frame, parts in found.items()]
    return set_track(document, address, track.with_keys(keys))


def parse_row(cells: list[str]) -> KeyRow:
    """Return the row that a line of cells is; columns that are missing have what a new key has.

    Raises
    ------
    UsageProblem
        A cell is not what its column holds.
    """
    defaults = ("", "1", "", Interpolation.LINEAR.value, "0", "33.333333", "0", "33.333333")
    whole = [cells[index].strip() if index < len(cells) else default for index, default in enumerate(defaults)]
    frame, component = _number(whole[0], Message("a frame")), _number(whole[1], Message("a component"))
    if frame < 1 or frame != int(frame) or component < 1 or component != int(component):
        raise UsageProblem(
            Message(
                "{frame!r}, {component!r} are not a frame and a component, whole numbers from 1",
                frame=whole[0],
                component=whole[1],
            )
        )
    if whole[3] not in list(Interpolation):
        raise UsageProblem(
            Message("{text!r} is not one of {words}", text=whole[3][:30], words=", ".join(Interpolation))
        )
    into = Ease(_number(whole[4], Message("a speed")), _influence(whole[5]))
    out = Ease(_number(whole[6], Message("a speed")), _influence(whole[7]))
    return KeyRow(
        int(frame), int(component) - 1, _number(whole[2], Message("a value")), Interpolation(whole[3]), into, out
    )


def _key(address: Address, track: Track, frame: int, parts: dict[int, KeyRow]) -> Key:
    like = track.value_at(frame)
    count = len(components_of(like) or ())
    if sorted(parts) != list(range(count)):
        raise UsageProblem(
            Message("frame {frame} needs {count} rows, one for each component", frame=frame, count=count)
        )
    ordered = [parts[component] for component in range(count)]
    value = address.property.canonical(rebuilt(like, tuple(row.value for row in ordered)))
    eases_in, eases_out = tuple(row.ease_in for row in ordered), tuple(row.ease_out for row in ordered)
    return Key(frame, value, ordered[0].interpolation, eases_in, eases_out)


def _typed(row: KeyRow, changed: KeyRow, column: int) -> KeyRow:
    """Return the row with the one ease number of a column as it was typed."""
    match column:
        case 4:
            return replace(row, ease_in=replace(row.ease_in, speed=changed.ease_in.speed))
        case 5:
            return replace(row, ease_in=replace(row.ease_in, influence=changed.ease_in.influence))
        case 6:
            return replace(row, ease_out=replace(row.ease_out, speed=changed.ease_out.speed))
        case _:
            return replace(row, ease_out=replace(row.ease_out, influence=changed.ease_out.influence))


def _calculated(row: KeyRow, column: int, text: str, factor: float) -> str:
    """Return what was typed into a cell as plain text: ``*2`` and its like are about the number that was there.

    What is itself in per cent keeps its sign: it says nothing about what was there.
    """
    if column not in _NUMBERS:
        return text
    times = factor if column in _IN_UNITS else 1.0
    is_per_cent = column in _INFLUENCES or times == _PER_CENT
    typed = text.strip().removesuffix("%") if is_per_cent else text
    # Rounded far behind what anybody types, or 30 % would become 0.3 and a little.
    return repr(round(evaluate(typed, float(row.exact_cells[column]) * times) / times, 12))


def _with_eases(key: Key, component: int, row: KeyRow) -> Key:
    count = len(components_of(key.value) or ())
    into = [_at(key.ease_in, index) for index in range(count)]
    out = [_at(key.ease_out, index) for index in range(count)]
    into[component], out[component] = row.ease_in, row.ease_out
    return replace(key, ease_in=tuple(into), ease_out=tuple(out))


def _at(eases: tuple[Ease, ...], component: int) -> Ease:
    return eases[component] if component < len(eases) else EASY


def _rounded(number: float) -> str:
    """Return a number with two decimals at most."""
    text = f"{number:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _number(text: str, what: Message) -> float:
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not abs(number) <= _MOST:
        raise UsageProblem(Message("{text!r} is not {what}", text=text[:30], what=what))
    return number


def _influence(text: str) -> float:
    return min(max(_number(text.rstrip("% "), Message("an influence")) / 100, MIN_INFLUENCE), 1.0)
