"""What programs make of hand-overs, by their documented maths, to be held against the picture."""

from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray
from psd_tools import PSDImage
from psd_tools.constants import BlendMode

from kagezou.document.model import Document
from kagezou.io.images.reading import read_cel
from kagezou.io.pixels.colour import coded_from_light
from tests.export.after_effects.compositing import EIGHT, SIXTEEN, composed
from tests.export.after_effects.hand_offs import built, handed_off
from tests.export.small_cuts import export

Pixels = NDArray[np.float64]
"""(H, W, 4), straight, 0 to 1."""
Seen = Callable[[int], Pixels]
"""What a frame, from 1, shows."""


def picture(document: Document, folder: Path) -> Seen:
    """Return the picture as the command line renders it."""
    export(document, folder, composite=True)
    return lambda frame: (
        read_cel(folder / f"composite/composite_{frame:04d}.png", white_is_clear=False).rgba.astype(float) / 255
    )


def in_after_effects(document: Document, folder: Path, full: int = EIGHT, **options: object) -> Seen:
    """Return what the composition shows that the script builds, in a project of 8 or of 16 bit."""
    folder.mkdir()
    run = built(handed_off(document, folder / "ae", **options), folder)
    return lambda frame: composed(run, "cut", frame, full) / full


def in_photoshop(document: Document, folder: Path, depth: int = 8, *, rounds: bool = True) -> Seen:
    """Return what the layers of each document show, rounded to its depth after each of them as Photoshop does."""
    export(document, folder, layered=True, format="psd", depth=depth)
    steps = ((1 << depth) - 1) if rounds else 0
    return lambda frame: _of_layers(PSDImage.open(folder / f"layered/layered_{frame:04d}.psd"), steps)


def in_light(document: Document, folder: Path) -> Seen:
    """Return what the parts of each OpenEXR file show, each turned into coded colours before it is laid."""
    export(document, folder, layered=True, format="exr", depth=16)
    return lambda frame: _of_parts(folder / f"layered/layered_{frame:04d}.exr")


HAND_OVERS: Final[dict[str, Callable[[Document, Path], Seen]]] = {
    "After Effects 8 bit": lambda document, folder: in_after_effects(document, folder, per_drawing=True),
    "After Effects 16 bit": lambda document, folder: in_after_effects(document, folder, SIXTEEN, depth=16),
    "PSD 8 bit": in_photoshop,
    "PSD 8 bit, exact": lambda document, folder: in_photoshop(document, folder, rounds=False),
    "PSD 16 bit": lambda document, folder: in_photoshop(document, folder, 16),
    "EXR": in_light,
}


ROUNDED: Final = frozenset({"After Effects 8 bit", "PSD 8 bit"})
"""Those that are laid in 8 bit, as the picture is."""


def levels_between(found: Pixels, wanted: Pixels) -> int:
    """Return by how many levels of 8 bit two pictures differ most, in alpha, and laid on black and on white."""
    return max(
        int(np.abs(np.rint(one * 255) - np.rint(other * 255)).max())
        for one, other in zip(_on_papers(found), _on_papers(wanted), strict=True)
    )


def laid(over: Pixels, under: Pixels, *, multiply: bool) -> Pixels:
    """Lay one picture over another, as PDF and Photoshop define it for pictures with alpha."""
    a, b = over[..., 3:], under[..., 3:]
    mixed = over[..., :3] * under[..., :3] if multiply else over[..., :3]
    alpha = a + b * (1 - a)
    light = a * (1 - b) * over[..., :3] + a * b * mixed + (1 - a) * b * under[..., :3]
    return np.concatenate([light / np.where(alpha > 0, alpha, 1), alpha], -1)


def _on_papers(shown: Pixels) -> tuple[Pixels, Pixels, Pixels]:
    black = shown[..., :3] * shown[..., 3:]
    return shown[..., 3:], black, black + 1 - shown[..., 3:]


def _of_layers(document: Any, steps: int) -> Pixels:
    shown = np.zeros((document.height, document.width, 4))
    for layer in document:
        over = _of_group(layer, shown.shape, steps) if layer.is_group() else _placed(layer, shown.shape)
        over[..., 3] *= layer.opacity / 255
        shown = _rounded(laid(over, shown, multiply=layer.blend_mode == BlendMode.MULTIPLY), steps)
    return shown


def _of_group(group: Any, shape: tuple[int, ...], steps: int) -> Pixels:
    """Return a group that is laid as one: its layers on each other, and its mask."""
    assert group.blend_mode is not BlendMode.PASS_THROUGH
    shown = np.zeros(shape)
    for layer in group:
        shown = _rounded(laid(_placed(layer, shape), shown, multiply=False), steps)
    if group.has_mask():
        mask = np.full(shape[:2], group.mask.background_color / 255.0)
        left, top, right, bottom = group.mask.bbox
        mask[top:bottom, left:right] = _mask_of(group)
        shown[..., 3] *= mask
    return shown


def _mask_of(group: Any) -> Pixels:
    picture = group.mask.topil()
    pixels = np.asarray(picture).astype(float)
    return pixels / (255 if pixels.max() <= 255 else 65535)


def _placed(layer: Any, shape: tuple[int, ...]) -> Pixels:
    whole = np.zeros(shape)
    left, top, right, bottom = layer.bbox
    if right > left and bottom > top:
        pixels = layer.numpy()
        assert pixels.shape[2] == 4
        whole[top:bottom, left:right] = pixels
    return whole


def _rounded(shown: Pixels, steps: int) -> Pixels:
    return np.rint(shown * steps) / steps if steps else shown


def _of_parts(path: Path) -> Pixels:
    source: Any = oiio.ImageInput.open(str(path))
    spec = source.spec()
    shown = np.zeros((spec.full_height, spec.full_width, 4))
    united, pending, blend, index = "", np.zeros_like(shown), "", 0
    while source.seek_subimage(index, 0):
        spec = source.spec()
        group = spec.get_string_attribute("kagezou:united")
        part = _coded(source, index, shown.shape)
        if united and group != united:
            shown, united = laid(pending, shown, multiply=blend == "multiply"), ""
        blend = spec.get_string_attribute("kagezou:blend")
        if not group:
            shown = laid(part, shown, multiply=blend == "multiply")
        elif united:
            pending = np.where(part[..., 3:] > pending[..., 3:], part, pending)
        else:
            united, pending = group, part
        index += 1
    source.close()
    return laid(pending, shown, multiply=blend == "multiply") if united else shown


def _coded(source: Any, index: int, shape: tuple[int, ...]) -> Pixels:
    """Return a part as straight sRGB on the canvas."""
    spec = source.spec()
    light = source.read_image(index, 0, 0, 4, oiio.FLOAT)
    whole = np.zeros(shape)
    place = (slice(spec.y, spec.y + spec.height), slice(spec.x, spec.x + spec.width))
    whole[(*place, slice(0, 3))] = coded_from_light(light[..., :3], light[..., 3]) / 65535
    whole[(*place, slice(3, 4))] = light[..., 3:]
    return whole
