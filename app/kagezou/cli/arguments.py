"""How arguments are read: one sentence for what is wrong, with what was probably meant."""

import argparse
from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import isfinite, nan
from pathlib import Path
from typing import Final, NoReturn

from kagezou.animation.timecode import parse_rate
from kagezou.errors import UsageProblem
from kagezou.message import Message, nearest

LARGEST_SIDE_PX: Final = 16384


class Parser(argparse.ArgumentParser):
    """An argument parser that raises UsageProblem, takes no abbreviations and prints examples as they are written."""

    def __init__(self, verb: str, description: str, examples: str) -> None:
        super().__init__(
            prog=f"kagezou {verb}",
            description=description,
            epilog=f"examples:\n{examples}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
            allow_abbrev=False,
        )

    def error(self, message: str) -> NoReturn:
        """Raise UsageProblem with the message and where help is."""
        raise UsageProblem(Message("{message} (see {prog} --help)", message=message, prog=self.prog))

    def has(self, option: str) -> bool:
        """Return whether there is an option."""
        return any(option in action.option_strings for action in self._actions)

    def described(self) -> tuple[tuple[str, str], ...]:
        """Return how each argument and option is typed, and what its help says."""
        helped = ((each, each.help) for each in self._actions)
        return tuple(
            (_typed(action), says.replace("%%", "%")) for action, says in helped if says and says != argparse.SUPPRESS
        )

    def options_of(self, words: Sequence[str]) -> argparse.Namespace:
        """Parse words in any order, and name the option that was probably meant by one there is not."""
        found, unknown = self.parse_known_intermixed_args(words)
        if unknown:
            options = [text for action in self._actions for text in action.option_strings]
            wrong = next((text for text in unknown if text.startswith("-")), unknown[0])
            self.error(f"{wrong!r} is not expected here{did_you_mean(wrong.split('=')[0], options)}")
        return found


def _typed(action: argparse.Action) -> str:
    choices = "" if action.choices is None else f"{{{','.join(map(str, action.choices))}}}"
    value = action.metavar if isinstance(action.metavar, str) else choices or action.dest.upper()
    return " ".join([", ".join(action.option_strings), "" if action.nargs == 0 else value]).strip()


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return ``"; did you mean X?"``, or nothing where nothing is near."""
    near = nearest(word, known)
    return "" if near is None else f"; did you mean {near}?"


def project_path(text: str) -> Path:
    """Return the path of a project file."""
    if not text:
        raise argparse.ArgumentTypeError("the name of a project file is empty")
    return Path(text)


def size(text: str) -> tuple[int, int]:
    """Return ``WIDTHxHEIGHT`` as px."""
    sides = text.lower().replace("×", "x").split("x")
    if len(sides) != 2 or not all(side.isascii() and side.isdigit() and len(side) <= 6 for side in sides):
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 1920x1080")
    width, height = (int(side) for side in sides)
    if not (1 <= width <= LARGEST_SIDE_PX and 1 <= height <= LARGEST_SIDE_PX):
        raise argparse.ArgumentTypeError(f"{text!r} is not within 1x1 and {LARGEST_SIDE_PX}x{LARGEST_SIDE_PX} px")
    return width, height


def frame_rate(text: str) -> Fraction:
    """Return frames a second: ``24``, ``23.976``, ``24000/1001``."""
    try:
        return parse_rate(text)
    except UsageProblem as problem:
        raise argparse.ArgumentTypeError(str(problem)) from problem


def whole_number(text: str) -> int:
    """Return a number of 1 and more."""
    if not (text.isascii() and text.isdigit() and len(text) <= 9 and int(text) >= 1):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number of 1 or more")
    return int(text)


def number_from_0(text: str) -> int:
    """Return a number of 0 and more."""
    if not (text.isascii() and text.isdigit() and len(text) <= 9):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number of 0 or more")
    return int(text)


def named_source(text: str) -> tuple[str, Path]:
    """Return ``NAME=PATH`` as its two parts."""
    name, sign, path = text.partition("=")
    if not sign or not name.strip() or not path:
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=FOLDER_OR_FILE")
    return name.strip(), Path(path)


def named_part(text: str) -> tuple[str, Path, str]:
    """Return ``CHARACTER=NAME=PATH`` as the name of the cel, its path and the character that it joins."""
    figure, sign, rest = text.partition("=")
    try:
        name, path = named_source(rest)
    except argparse.ArgumentTypeError:
        name, path = "", Path()
    if not sign or not figure.strip() or not name:
        raise argparse.ArgumentTypeError(f"{text!r} is not CHARACTER=NAME=FOLDER_OR_FILE")
    return name, path, figure.strip()


def positive(text: str) -> float:
    """Return a number over 0."""
    try:
        number = float(text)
    except ValueError:
        number = nan
    if not (isfinite(number) and number > 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number over 0")
    return number


def point(text: str) -> tuple[float, float]:
    """Return ``X,Y`` as a point of the canvas."""
    parts = text.strip("[]").split(",")
    try:
        x, y = (float(part) for part in parts)
    except ValueError:
        x = y = nan
    if not (isfinite(x) and isfinite(y)):
        raise argparse.ArgumentTypeError(f"{text!r} is not a point such as 960,870")
    return x, y
