"""How rendered files are called: the options that several commands share."""

from argparse import Namespace
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, number_from_0, whole_number

if TYPE_CHECKING:
    from kagezou.export.file_names import FileNames


def add_naming(parser: Parser) -> None:
    """Say what can be typed of the names of files."""
    parser.add_argument(
        "--names",
        metavar="PATTERN",
        help="how files are called under DIR, without suffix: words out of {layer}, {kind}, {name}, {scene}, {cut} "
        "and, once, {frame}, {frame:04d}, #### or %%04d ('{layer}_{kind}/{layer}_{kind}_{frame}')",
    )
    parser.add_argument(
        "--start-frame",
        type=number_from_0,
        metavar="N",
        help="the number of the file of the cut's first frame, such as 1001 (as canvas.first_frame); --frames counts "
        "from 1 whatever it is",
    )
    parser.add_argument("--padding", type=whole_number, metavar="N", help="digits of the number, at least (4)")


def names_of(options: Namespace) -> "FileNames":
    """Return how files are to be called; UsageProblem where they cannot be."""
    from kagezou.export.file_names import USUAL, FileNames

    return FileNames(options.names or USUAL, options.start_frame, options.padding)
