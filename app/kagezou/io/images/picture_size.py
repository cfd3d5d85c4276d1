"""How large a picture may be: by its sides, by its memory, and by what memory the machine has left."""

from pathlib import Path
from typing import Final

from kagezou.io.files.faults import input_problem
from kagezou.io.files.memory import free_memory
from kagezou.io.images.header import Header
from kagezou.io.pixels.signatures import LARGEST_SIDE_PX
from kagezou.message import Message

LARGEST_PICTURE_MB: Final = 1024
"""So much memory may the stored pixels of a picture take that are read, and so much the canvas they lie on."""

_LARGEST_WEBP_MB: Final = 256
"""Its decoder holds three pictures."""

_COPIES: Final = 2
"""While a picture is read, its pixels are held at most so many times."""

_BYTES: Final = {"uint8": 1, "uint16": 2, "float16": 2, "float32": 4}


def check_size(path: Path, header: Header) -> None:
    """Refuse a picture before anything is allocated for it.

    Raises
    ------
    InputProblem
        It has no pixels, is larger than can be read, or than the memory that is free.
    """
    width, height = header.display[2:]
    stored_width, stored_height = header.data[2:]
    if min(width, height, stored_width, stored_height) < 1:
        raise input_problem(path, Message("it has no pixels"))
    canvas = width * height * 4 * (1 if header.dtype == "uint8" else 2)
    stored = stored_width * stored_height * len(header.used) * _BYTES[header.dtype]
    most = _LARGEST_WEBP_MB if header.format == "webp" else LARGEST_PICTURE_MB
    if max(width, height) > LARGEST_SIDE_PX or max(canvas, stored) > most << 20:
        raise input_problem(
            path, Message("{width} × {height} px is larger than can be read", width=width, height=height)
        )
    needed, free = _COPIES * max(canvas, stored), free_memory()
    if free is not None and needed > free:
        raise input_problem(
            path,
            Message(
                "{width} × {height} px need {needed} MB of memory to be read, of which {free} MB are free",
                width=width,
                height=height,
                needed=needed >> 20,
                free=free >> 20,
            ),
        )
