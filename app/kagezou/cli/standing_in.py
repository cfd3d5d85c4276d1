"""The option that says what stands in for drawings that are not there."""

from argparse import Namespace
from typing import TYPE_CHECKING, Final

from kagezou.cli.arguments import Parser

if TYPE_CHECKING:
    from kagezou.export.request import Missing

WAYS: Final = ("fail", "empty", "hold")


def add_missing(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument(
        "--missing",
        choices=WAYS,
        default=WAYS[0],
        help="where a drawing is not there: make nothing (fail), the frame without it (empty), or with the drawing "
        "before it, else after it (hold); said on stderr",
    )


def missing_of(options: Namespace) -> "Missing":
    """Return what was typed."""
    from kagezou.export.request import Missing

    return Missing(options.missing)
