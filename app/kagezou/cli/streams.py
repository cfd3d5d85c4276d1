"""The three standard streams, which whoever starts the program may have closed."""

import os
import sys
from typing import Final

_NUMBERS: Final = (0, 1, 2)


def open_closed_streams() -> None:
    """Let streams that are closed lead nowhere.

    Else the next file that is opened gets the number of a stream, and what a library prints would go into it.
    """
    if os.name == "posix":
        for number in _NUMBERS:
            try:
                os.fstat(number)
            except OSError:
                # The system gives the lowest free number.
                os.open(os.devnull, os.O_RDWR)
    # Python has no object for a stream that was closed when it began; nor has a program without a console.
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode, encoding="utf-8"))  # noqa: PTH123, SIM115 - open to the very end
