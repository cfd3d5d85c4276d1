"""One frame as one file of layers: a Photoshop document or an OpenEXR file of several parts.

The same frame gives the same bytes. Both are read back before they take their place.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Final

import numpy as np

from kagezou.errors import UsageProblem
from kagezou.io.files.atomic import replace_by, write_bytes
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.pixels.colour import light_from_rgba
from kagezou.io.pixels.layers import LayeredImage, LayerPart
from kagezou.message import Message

if TYPE_CHECKING:  # OpenImageIO is loaded with the first file that needs it
    from kagezou.io.images.oiio_parts import ExrPart

LAYERED_FORMATS: Final = (".exr", ".psd")
"""The suffixes of files of layers."""


def write_layered(path: Path, image: LayeredImage) -> None:
    """Write ``image`` in the format of the suffix: PSD in its depth, OpenEXR as premultiplied halves.

    Raises
    ------
    UsageProblem
        The suffix is none of `LAYERED_FORMATS`.
    DiskFullProblem, OutputProblem
        It cannot be written; what was at ``path`` is still there.
    """
    match path.suffix.lower():
        case ".exr":
            from kagezou.io.images.oiio_parts import write_parts_verified

            size_px = (image.width_px, image.height_px)
            parts = [_exr_part(part) for part in image.parts]
            replace_by(path, lambda temp: write_parts_verified(temp, size_px, parts, path))
        case ".psd":
            from kagezou.io.psd.writing import packed_psd

            try:
                data = packed_psd(image)
            except ValueError as error:
                raise output_problem(path, Message("{cause}", cause=error)) from error
            write_bytes(path, data)
        case _:
            raise UsageProblem(
                Message(
                    "{path}: layers are written as {layered_formats}",
                    path=shown(path),
                    layered_formats=" or ".join(LAYERED_FORMATS),
                )
            )


def _exr_part(part: LayerPart) -> "ExrPart":
    """Return a part as linear light; OpenEXR has no empty part, so that one clear pixel stands for it.

    It has no groups either: the name of a part in one begins with the group's, and a dot.
    """
    from kagezou.io.images.oiio_parts import ExrPart

    united = part.group.name if part.group else ""
    name = f"{united}.{part.name}" if united else part.name
    blend = "multiply" if part.multiply else "normal"
    if part.box.is_empty:
        return ExrPart(name, (0, 0), np.zeros((1, 1, 4), np.float16), blend, united)
    return ExrPart(name, (part.box.left, part.box.top), light_from_rgba(part.pixels), blend, united)
