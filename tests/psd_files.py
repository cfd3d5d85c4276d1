"""PSD files as drawing programs save them, made with psd-tools."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from psd_tools import PSDImage
from psd_tools.constants import BlendMode, Clipping, Tag
from psd_tools.psd.layer_and_mask import ChannelData, ChannelDataList, ChannelInfo, MaskData, MaskFlags, MaskParameters
from psd_tools.psd.vector import ClosedKnotLinked, ClosedPath, InitialFillRule, PathFillRule
from psd_tools.psd.vector import Path as VectorPath

SIZE = (64, 48)


@dataclass(frozen=True)
class Cut:
    """Masks of a layer or a group, as Photoshop keeps them.

    A painted one (h, w) ``uint8`` that lies at ``corner`` with a value around it, a rectangular path by its sides left,
    top, right, bottom in px, and of each its density, 0 to 255, and the width of its soft edge, px.
    """

    painted: NDArray[np.uint8] | None = None
    corner: tuple[int, int] = (0, 0)
    around: int = 0
    density: int | None = None
    feather: float | None = None
    path: tuple[float, float, float, float] | None = None
    path_density: int | None = None
    path_feather: float | None = None


@dataclass(frozen=True)
class Leaf:
    """A layer: its pixels (h, w, 4) ``uint8`` and where they lie."""

    name: str
    pixels: NDArray[np.uint8]
    offset: tuple[int, int] = (0, 0)
    is_visible: bool = True
    opacity: int = 255
    blend: BlendMode = BlendMode.NORMAL
    is_clipped: bool = False
    cut: Cut | None = None


@dataclass(frozen=True)
class Folder:
    """A group, from its lowest layer up."""

    name: str
    children: Sequence["Leaf | Folder"]
    is_visible: bool = True
    opacity: int = 255
    blend: BlendMode = BlendMode.NORMAL
    is_clipped: bool = False
    cut: Cut | None = None


def block(width: int, height: int, color: tuple[int, int, int, int] = (200, 120, 40, 255)) -> NDArray[np.uint8]:
    """A plain rectangle."""
    return np.full((height, width, 4), color, np.uint8)


def figure(seed: int) -> NDArray[np.uint8]:
    """A soft-edged blot, 20 × 30 px, another one for every seed."""
    random = np.random.default_rng(seed)
    pixels = random.integers(0, 256, (30, 20, 4)).astype(np.uint8)
    pixels[8:24, 5:15, 3] = 255
    return pixels


def on_canvas(leaf: Leaf, size: tuple[int, int] = SIZE) -> NDArray[np.uint8]:
    """Return the layer's pixels as a drawing as large as the file, clear around."""
    canvas = np.zeros((size[1], size[0], 4), np.uint8)
    height, width = leaf.pixels.shape[:2]
    x, y = leaf.offset
    left, top, right, bottom = max(x, 0), max(y, 0), min(x + width, size[0]), min(y + height, size[1])
    if left < right and top < bottom:
        canvas[top:bottom, left:right] = leaf.pixels[top - y : bottom - y, left - x : right - x]
    return canvas


def write_psd(
    path: Path,
    layers: Sequence[Leaf | Folder],
    size: tuple[int, int] = SIZE,
    mode: str = "RGBA",
    *,
    is_pictured: bool = True,
) -> Path:
    """Write a file of layers, from the lowest up, with the picture that they make where it is one of RGB."""
    image = PSDImage.new(mode, size)
    _fill(image, layers)
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path)
    return with_picture(path) if mode == "RGBA" and is_pictured else path


def with_picture(path: Path, picture: NDArray[np.uint8] | None = None) -> Path:
    """Give a file of layers the picture (H, W, 4) that a program saves with them: its own, or another.

    psd-tools would save one that is clear everywhere.
    """
    image = PSDImage.open(path)
    pixels = np.asarray(image.composite(force=True).convert("RGBA")) if picture is None else picture
    colour, alpha = pixels[..., :3].astype(int), pixels[..., 3:].astype(int)
    on_white = ((colour * alpha + 255 * (255 - alpha) + 127) // 255).astype(np.uint8)
    planes = [plane.tobytes() for plane in np.moveaxis(np.concatenate([on_white, pixels[..., 3:]], 2), 2, 0)]
    image._record.image_data.set_data(planes, image._record.header)
    image.save(path)
    return path


def write_flat(path: Path, picture: Image.Image) -> Path:
    """Write a file without layers."""
    PSDImage.frompil(picture).save(path)
    return path


def _fill(group: Any, layers: Sequence[Leaf | Folder]) -> None:
    for each in layers:
        if isinstance(each, Folder):
            made = group.create_group(opacity=each.opacity, blend_mode=each.blend)
            _fill(made, each.children)
        else:
            x, y = each.offset
            picture = Image.fromarray(each.pixels, "RGBA")
            made = group.create_pixel_layer(
                picture, name="x", top=y, left=x, opacity=each.opacity, blend_mode=each.blend
            )
            made.clipping = each.is_clipped
        # Named afterwards: only so the name is kept as Unicode.
        made.name = each.name
        made.visible = each.is_visible
        if each.is_clipped:
            made._record.clipping = Clipping.NON_BASE
        if each.cut is not None:
            _cut(made, each.cut)


def _cut(layer: Any, cut: Cut) -> None:
    record, parts = layer._record, (cut.density, cut.feather, cut.path_density, cut.path_feather)
    if cut.path is not None:
        layer.tagged_blocks.set_data(Tag.VECTOR_MASK_SETTING1, 3, 0, _rectangle(cut.path, SIZE))
    planes = list(_planes(cut))
    if not planes:
        return
    # A group that psd-tools makes shares its planes with the hidden layer at its lower end.
    if layer.is_group():
        layer._bounding_channels = ChannelDataList(list(layer._channels))
        layer._psd._update_record()
    layer.create_mask(Image.fromarray(planes[0][1], "L"))
    for kind, pixels in planes[1:]:
        record.channel_info.append(ChannelInfo(kind, 2 + pixels.size))
        plane = ChannelData()
        plane.set_data(pixels.tobytes(), pixels.shape[1], pixels.shape[0], 8)
        layer._channels.append(plane)
    first = planes[0][1]
    x, y = cut.corner if cut.path is None else (0, 0)
    flags = MaskFlags(user_mask_from_render=cut.path is not None, parameters_applied=any(parts))
    record.mask_data = MaskData(
        y, x, y + first.shape[0], x + first.shape[1], cut.around, flags, MaskParameters(*parts) if any(parts) else None
    )
    if len(planes) > 1:
        own, (x, y) = planes[1][1], cut.corner
        record.mask_data.real_flags = MaskFlags()
        record.mask_data.real_background_color = cut.around
        record.mask_data.real_top, record.mask_data.real_left = y, x
        record.mask_data.real_bottom, record.mask_data.real_right = y + own.shape[0], x + own.shape[1]


def _planes(cut: Cut) -> Iterator[tuple[int, NDArray[np.uint8]]]:
    """Yield the kind and the pixels of stored masks: both together first where there are both."""
    parts = (cut.density, cut.feather, cut.path_density, cut.path_feather)
    if cut.path is not None and (cut.painted is not None or any(parts)):
        yield -2, np.full((SIZE[1], SIZE[0]), 77, np.uint8)  # what a reader that takes this for the mask would see
    if cut.painted is not None:
        yield (-2 if cut.path is None else -3), cut.painted


def _rectangle(sides: tuple[float, float, float, float], size: tuple[int, int]) -> Any:
    left, top, right, bottom = (side / size[index % 2] for index, side in enumerate(sides))
    corners = [(top, left), (top, right), (bottom, right), (bottom, left)]
    knots: Any = [ClosedKnotLinked(corner, corner, corner) for corner in corners]
    items: Any = [PathFillRule(), InitialFillRule(0), ClosedPath(knots, operation=1)]
    return VectorPath(items)
