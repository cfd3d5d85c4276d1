"""OpenEXR files of several named parts, written by OpenImageIO and read back."""

import shutil
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray

from kagezou.io.files.faults import output_problem
from kagezou.io.images.oiio_errors import first_line
from kagezou.io.images.oiio_guard import configure, disk_full, lacks_end
from kagezou.message import Message

BLEND: Final = "kagezou:blend"
"""The attribute that says how a part lies on those before it: ``normal`` or ``multiply``."""

UNITED: Final = "kagezou:united"
"""The attribute of parts that are laid as one, by the maximum of their alphas: the name of their group."""


@dataclass(frozen=True, eq=False)
class ExrPart:
    """A part as the file shall hold it.

    Attributes
    ----------
    name
        Unlike that of every other part.
    corner_px
        Where its first pixel lies on the canvas: x, y.
    light
        (H, W, 4) ``float16``, linear, multiplied by alpha.
    blend
        The value of `BLEND`.
    united
        The value of `UNITED`, empty for none.
    """

    name: str
    corner_px: tuple[int, int]
    light: NDArray[np.float16]
    blend: str
    united: str = ""


def write_parts_verified(temp: Path, size_px: tuple[int, int], parts: Sequence[ExrPart], shown_as: Path) -> None:
    """Write parts to ``temp`` and read them back.

    Parameters
    ----------
    temp
        Where to write.
    size_px
        Width and height of the canvas; each part stores its own pixels alone.
    parts
        From the bottom, at least one.
    shown_as
        The file's name in messages.

    Raises
    ------
    DiskFullProblem, OutputProblem
        The writer complains, or what it wrote reads back differently.
    """
    configure()
    cause = _written(temp, [_spec(part, size_px) for part in parts], parts) or _differs(temp, parts)
    cause = cause or lacks_end(temp)
    if not cause:
        return
    if shutil.disk_usage(temp.parent).free < sum(part.light.nbytes for part in parts):
        raise disk_full(shown_as)
    raise output_problem(shown_as, Message("cannot be written: {cause}", cause=cause))


def _spec(part: ExrPart, size_px: tuple[int, int]) -> oiio.ImageSpec:
    height, width = part.light.shape[:2]
    spec = oiio.ImageSpec(width, height, 4, oiio.HALF)
    spec.x, spec.y = part.corner_px
    spec.full_width, spec.full_height = size_px
    # Without a given DateTime the writer puts in the present one.
    settings = {"oiio:subimagename": part.name, "compression": "zip", "DateTime": "", BLEND: part.blend}
    if part.united:
        settings[UNITED] = part.united
    for name, value in settings.items():
        spec.attribute(name, value)
    return spec


def _written(temp: Path, specs: list[oiio.ImageSpec], parts: Sequence[ExrPart]) -> str:
    """Write, and return what went wrong or an empty text."""
    oiio.geterror()
    try:
        out = oiio.ImageOutput.create(str(temp))
        if out is None:
            return first_line(oiio.geterror())
        done = out.open(str(temp), tuple(specs))
        for index, part in enumerate(parts):
            done = done and (index == 0 or out.open(str(temp), specs[index], "AppendSubimage"))
            done = done and out.write_image(np.ascontiguousarray(part.light))
        done = out.close() and done
    except (TypeError, MemoryError, RuntimeError, ValueError) as error:
        return first_line(str(error))
    message = first_line(out.geterror())
    return message if message or done else "the writer refuses"


def _differs(temp: Path, parts: Sequence[ExrPart]) -> str:
    """Read back, and return what differs or an empty text."""
    source = oiio.ImageInput.open(str(temp))
    if source is None:
        return f"it does not read back: {first_line(oiio.geterror())}"
    try:
        for index, part in enumerate(parts):
            back = source.read_image(index, 0, 0, 4, oiio.HALF) if source.seek_subimage(index, 0) else None
            alike = back is not None and np.array_equal(back.view(np.uint16), part.light.view(np.uint16))
            if not alike or source.geterror() or source.spec().get_string_attribute("oiio:subimagename") != part.name:
                return "it reads back differently from what was written"
    finally:
        source.close()
    return ""
