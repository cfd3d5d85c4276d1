"""What a property is: its kind, unit, range, default and words, and how a raw value becomes a valid one."""

from dataclasses import dataclass
from enum import StrEnum
from math import isfinite
from typing import Generic, TypeAlias, TypeVar

from kagezou.animation.track import Value
from kagezou.errors import UsageProblem
from kagezou.message import Message

MAX_COORDINATE_PX = 1_000_000.0
MAX_POINTS = 64

T_co = TypeVar("T_co", bound=Value, covariant=True)


class Kind(StrEnum):
    """The shape of a property's value."""

    NUMBER = "number"
    POINT = "point"
    """(x, y) on the canvas."""
    PLACE = "place"
    """(x, y, z) in the world."""
    POINTS = "points"
    """Any number of canvas points."""
    COLOR = "color"
    """``#RRGGBB``, sRGB."""
    CHOICE = "choice"
    SWITCH = "switch"


class Scope(StrEnum):
    """What a property belongs to."""

    DOCUMENT = "document"
    LAYER = "layer"
    PIECE = "piece"


class Usual(StrEnum):
    """Where a property's value comes from while nobody has set it."""

    DEFAULT = "default"
    CANVAS_MIDDLE = "the middle of the canvas"
    DRAWING_MIDDLE = "the middle of the layer's drawing"


class ValueProblem(UsageProblem):
    """A value that a property cannot have.

    Attributes
    ----------
    cause
        Why, without the name of the property.
    """

    def __init__(self, name: str, cause: Message) -> None:
        super().__init__(Message("{name}: {cause}", name=name, cause=cause))
        self.cause = cause


@dataclass(frozen=True, slots=True)
class Property(Generic[T_co]):
    """One line of the property table; ``Property[float]`` is one whose values are numbers.

    Parameters
    ----------
    name
        The path; for a property of a layer or a set piece the part after ``layers.NAME.`` or ``set.NAME.``.
    kind, scope, unit
        ``unit`` is "px", "°", "%" or "" for a plain number.
    default
        What it is where nothing was ever set; every value is of its type.
    low, high
        The range of a number, both ends included.
    choices
        The words a choice may take.
    slides
        The part of the range that a slider offers, where a slider is natural.
    usual
        What it is where nothing was ever set; ``default`` unless that depends on the cut.
    label, help
        What the window and the help print.
    """

    name: str
    kind: Kind
    scope: Scope
    default: T_co
    label: Message
    help: Message
    unit: str = ""
    low: float = -MAX_COORDINATE_PX
    high: float = MAX_COORDINATE_PX
    choices: tuple[str, ...] = ()
    slides: tuple[float, float] | None = None
    usual: Usual = Usual.DEFAULT

    def __hash__(self) -> int:
        """By scope and name, which tell the lines of the table apart; selected keys are looked up by the thousand."""
        return hash((self.scope, self.name))

    @property
    def holds_only(self) -> bool:
        """Whether keys of this property may only be held: switches and choices."""
        return self.kind in (Kind.CHOICE, Kind.SWITCH)

    @property
    def components(self) -> tuple[str, ...]:
        """The names of the value's numbers; empty where it has none or any number of them."""
        match self.kind:
            case Kind.NUMBER:
                return (str(self.label),)
            case Kind.POINT:
                return ("x", "y")
            case Kind.PLACE:
                return ("x", "y", "z")
            case Kind.COLOR:
                return ("red", "green", "blue")
            case _:
                return ()

    def typed(self, value: Value) -> T_co:
        """Return a value of this property's track as what it is; TypeError if it cannot be one of this property."""
        if isinstance(value, type(self.default)):
            return value
        raise TypeError(f"{self.name} cannot be {value!r}")

    def canonical(self, raw: object) -> T_co:
        """Return ``raw`` (a JSON value or a value of this property) as a valid value of this property.

        Raises
        ------
        UsageProblem
            A ValueProblem: one sentence that says what is wrong and what is allowed.
        """
        return self.typed(self._checked(raw))

    def _checked(self, raw: object) -> Value:
        match self.kind:
            case Kind.NUMBER:
                return self._number(raw)
            case Kind.POINT:
                x, y = self._coordinates(raw, 2)
                return (x, y)
            case Kind.PLACE:
                return self._coordinates(raw, 3)
            case Kind.POINTS:
                return self._points(raw)
            case Kind.COLOR:
                return self._color(raw)
            case Kind.CHOICE:
                if isinstance(raw, str) and raw in self.choices:
                    return raw
                raise self._refused(
                    raw, Message("one of {choices}", choices=", ".join(f'"{choice}"' for choice in self.choices))
                )
            case Kind.SWITCH:
                if isinstance(raw, bool):
                    return raw
                raise self._refused(raw, Message("true or false"))

    def _number(self, raw: object) -> float:
        number = _finite(raw)
        if number is None or not self.low <= number <= self.high:
            raise self._refused(
                raw,
                Message(
                    "a number from {low:g} to {high:g}{unit}",
                    low=self.low,
                    high=self.high,
                    unit=self.unit and " " + self.unit,
                ),
            )
        return number

    def _coordinates(self, raw: object, count: int) -> tuple[float, ...]:
        wanted = Message("a point [{axes}] in {unit}", axes=", ".join("xyz"[:count]), unit=self.unit or "px")
        if not isinstance(raw, (list, tuple)) or len(raw) != count:
            raise self._refused(raw, wanted)
        numbers = tuple(_finite(part) for part in raw)
        inside = tuple(n for n in numbers if n is not None and abs(n) <= MAX_COORDINATE_PX)
        if len(inside) != count:
            raise self._refused(
                raw,
                Message(
                    "{wanted}, each within ±{most_coordinate_px:g}", wanted=wanted, most_coordinate_px=MAX_COORDINATE_PX
                ),
            )
        return inside

    def _points(self, raw: object) -> tuple[tuple[float, float], ...]:
        if not isinstance(raw, (list, tuple)) or len(raw) > MAX_POINTS:
            raise self._refused(
                raw, Message("a list of at most {most_points} points [[x, y], …] in px", most_points=MAX_POINTS)
            )
        pairs = (self._coordinates(part, 2) for part in raw)
        return tuple((pair[0], pair[1]) for pair in pairs)

    def _color(self, raw: object) -> str:
        if isinstance(raw, str) and len(raw) == 7 and raw[0] == "#":
            digits = raw[1:]
            if all(digit in "0123456789abcdefABCDEF" for digit in digits):
                return "#" + digits.upper()
        raise self._refused(raw, Message('a colour such as "#20203A"'))

    def _refused(self, raw: object, wanted: Message) -> "ValueProblem":
        shown = repr(raw)
        value = shown if len(shown) <= 60 else shown[:57] + "..."
        return ValueProblem(self.name, Message("{value} is not {wanted}", value=value, wanted=wanted))


AnyProperty: TypeAlias = Property[Value]
"""A property whatever its values are."""


def _finite(raw: object) -> float | None:
    """Return a finite float, or None for anything that is not a plain number."""
    if isinstance(raw, bool) or not isinstance(raw, (int, float)):
        return None
    try:
        number = float(raw)
    except OverflowError:
        return None
    return number if isfinite(number) else None
