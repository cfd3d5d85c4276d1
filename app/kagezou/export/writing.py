"""One picture into all its files: encoded once, each file put in place as a whole."""

import numpy as np

from kagezou.export.jobs import FrameJob, ShadowContent
from kagezou.export.ledger import content_hash
from kagezou.export.pipeline import Image
from kagezou.geometry.box import Box
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem
from kagezou.io.images.layered import write_layered
from kagezou.io.images.writing import ShadowImage, encode_png, encode_rgba_png, write_rgba, write_shadow
from kagezou.io.pixels.layers import LayeredImage


def write_all(job: FrameJob, image: Image) -> str:
    """Write a picture into every file of its job, in the format of their suffix; return the hash of its bytes.

    Raises
    ------
    DiskFullProblem, OutputProblem
        A file cannot be written; what was there is still there.
    """
    first, *others = (target.path for target in job.targets)
    if first.suffix == ".png" and not isinstance(image, LayeredImage):
        data = encode_png(image) if isinstance(image, ShadowImage) else encode_rgba_png(image)
        write_bytes(first, data)
    else:
        if isinstance(image, LayeredImage):
            write_layered(first, image)
        elif isinstance(image, ShadowImage):
            write_shadow(first, image)
        else:
            write_rgba(first, image)
        try:
            data = first.read_bytes()
        except OSError as error:
            raise output_problem(first, error) from error
    for path in others:
        write_bytes(path, data)
    return content_hash(data)


def blank_image(job: FrameJob, content: ShadowContent, depth: int) -> ShadowImage:
    """Return the shadow of an empty cel or a hidden layer: its colour, clear everywhere."""
    canvas = job.scene.canvas
    alpha = np.zeros((0, 0), np.uint8 if depth == 8 else np.uint16)
    return ShadowImage(canvas.width, canvas.height, content.look.color, alpha, Box(0, 0, 0, 0))
