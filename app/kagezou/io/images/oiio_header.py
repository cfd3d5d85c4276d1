"""From what OpenImageIO says of an open file to the header of the picture in it that is meant."""

from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.images.exr_layers import ExrLayer, chosen_layer, layers_in
from kagezou.io.images.header import Header, not_used
from kagezou.io.images.oiio_errors import text_of
from kagezou.io.pixels.colour_change import ColourChange, light_change, power_curves
from kagezou.io.pixels.icc import change_by_profile
from kagezou.io.pixels.png_chunks import png_chunks
from kagezou.io.pixels.working_spaces import is_known_as_linear, primaries_called
from kagezou.message import Message

STRAIGHT: Final = "oiio:UnassociatedAlpha"
_DELIVERED: Final = {
    oiio.UINT8: "uint8",
    oiio.HALF: "float16",
    oiio.FLOAT: "float32",
    oiio.DOUBLE: "float32",
}
_TGA_ALPHA: Final = 3
_TGA_PREMULTIPLIED: Final = 4
_MOST_SUBIMAGES: Final = 1000
_WHITE_IS_ZERO: Final = 0
_PALETTE: Final = 3
_SMALLER_COPY: Final = 1
_EXTRA_AS_ALPHA: Final = Message("its fourth channel, of which it does not say what it is, was taken as alpha")
_EXTRA_OF_GRAY: Final = Message("its second channel, of which it does not say what it is, was taken as alpha")
_ADOBE_RGB: Final = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290)
_ADOBE_GAMMA: Final = 563 / 256


def header_of(path: Path, source: oiio.ImageInput, address: str | None) -> Header:
    """Return the header of a picture.

    Parameters
    ----------
    path
        The file, to be named in a problem.
    source
        The open file; it stands at the picture afterwards.
    address
        The name of a layer of an OpenEXR file, the number of a page of another; None for the picture itself.

    Raises
    ------
    InputProblem
        There is no such layer or page, or it is of a kind that cannot be read.
    """
    if source.format_name() == "openexr":
        return _exr_header(path, source, address)
    page = _sought_page(path, source, address)
    spec = source.spec()
    if spec.deep or spec.depth > 1:
        raise input_problem(path, Message("deep and volume pictures cannot be read"))
    kind = source.format_name()
    if any(name.startswith("ink") for name in spec.channelnames):
        raise input_problem(path, Message("its colours are inks with further channels, which cannot be read"))
    colour, alpha, notes = _channels(kind, spec)
    flagged = bool(spec.get_int_attribute(STRAIGHT))
    tga_type = spec.get_int_attribute("targa:alpha_type")
    is_associated = kind == "tiff" and spec.alpha_channel >= 0
    place = (0, 0, spec.width, spec.height)
    white_is_zero = (
        kind == "tiff"
        and spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == _WHITE_IS_ZERO
        and spec.format.size() > 1  # the decoder itself turns 8 bit and less
    )
    header = Header(
        format=kind,
        data=place,
        display=place,
        subimage=page,
        channels=spec.nchannels,
        colour=colour,
        alpha=alpha,
        alpha_declared=not notes and (tga_type >= _TGA_ALPHA if kind == "targa" else flagged or kind != "bmp"),
        dtype=_dtype(spec),
        bit_depth=_bits(spec),
        straight=flagged or not (is_associated or tga_type == _TGA_PREMULTIPLIED),
        orientation=spec.get_int_attribute("Orientation", 1),
        white_is_zero=white_is_zero,
        is_for_pillow=_is_for_pillow(kind, spec),
        notes=(*notes, *_unused_channels(spec, (*colour, alpha))),
    )
    return _in_colour(path, spec, header)


def no_such_part(path: Path, address: str | None) -> InputProblem:
    """Return the problem of a layer or a page that is not in its file."""
    return input_problem(path, Message("there is no layer {address!r} in it", address=address))


def page_index(path: Path, address: str | None) -> int:
    """Return the place of a page, from 0, by its number from 1; 0 for none.

    Raises
    ------
    InputProblem
        It is no number.
    """
    if address is None:
        return 0
    if not (address.isascii() and address.isdecimal() and 1 <= int(address[:9]) <= _MOST_SUBIMAGES):
        raise no_such_part(path, address)
    return int(address) - 1


def _sought_page(path: Path, source: oiio.ImageInput, address: str | None) -> int:
    """Return the place of a page in the file after going there."""
    page = 0
    if address is not None:
        pages = full_pages(source)
        if (number := page_index(path, address)) >= len(pages):
            raise no_such_part(path, address)
        page = pages[number]
    source.seek_subimage(page, 0)
    return page


def full_pages(source: oiio.ImageInput) -> tuple[int, ...]:
    """Return the places of the pictures in an open file that are no smaller copies of others."""
    found = []
    for index in range(_MOST_SUBIMAGES):
        if not source.seek_subimage(index, 0):
            text_of(source.geterror)
            break
        if not source.spec().get_int_attribute("tiff:subfiletype") & _SMALLER_COPY:
            found.append(index)
    return tuple(found)


def exr_layers(source: oiio.ImageInput) -> tuple[tuple[ExrLayer, ...], tuple[str, ...]]:
    """Return the layers of an open OpenEXR file, and the names of its deep parts, which cannot be read."""
    parts, deep = [], []
    for index in range(_MOST_SUBIMAGES):
        if not source.seek_subimage(index, 0):
            text_of(source.geterror)
            break
        spec = source.spec()
        name = spec.get_string_attribute("oiio:subimagename")
        if spec.deep or spec.depth > 1:
            deep.append(name or f"{index + 1}")
        else:
            parts.append((index, name, tuple(spec.channelnames)))
    return layers_in(parts), tuple(deep)


def _exr_header(path: Path, source: oiio.ImageInput, address: str | None) -> Header:
    layers, deep = exr_layers(source)
    layer = chosen_layer(layers) if address is None else next((each for each in layers if each.name == address), None)
    if layer is None:
        if address is not None:
            raise _no_such_layer(path, address, layers)
        if not deep:
            raise input_problem(path, Message("its pixels cannot be decoded"))
        raise input_problem(path, Message("deep and volume pictures cannot be read"))
    source.seek_subimage(layer.subimage, 0)
    spec = source.spec()
    colour = layer.colour or (() if layer.alpha is not None else (layer.others[0][1],))
    header = Header(
        format="openexr",
        data=(spec.x, spec.y, spec.width, spec.height),
        display=(spec.full_x, spec.full_y, spec.full_width, spec.full_height),
        subimage=layer.subimage,
        channels=spec.nchannels,
        colour=colour,
        alpha=layer.alpha,
        dtype=_dtype(spec),
        bit_depth=_bits(spec),
        straight=bool(spec.get_int_attribute(STRAIGHT)),
        notes=_layer_notes(layers, layer, deep, colour),
    )
    change, notes = _exr_colours(spec)
    return replace(header, change=change if len(colour) == 3 else None, notes=(*header.notes, *notes))


def _no_such_layer(path: Path, address: str, layers: tuple[ExrLayer, ...]) -> InputProblem:
    names = ", ".join(each.name or "''" for each in layers if each.is_picture)
    return input_problem(
        path, Message("there is no layer {address!r} in it, but there are: {names}", address=address, names=names)
    )


def _layer_notes(
    layers: tuple[ExrLayer, ...], layer: ExrLayer, deep: tuple[str, ...], colour: tuple[int, ...]
) -> tuple[Message, ...]:
    notes = []
    if layer.lends_alpha:
        notes.append(Message("the layer {layer} has no alpha of its own; that of the file is used", layer=layer.name))
    elif layer.alpha is None and any(each.alpha is not None for each in layers):
        notes.append(Message("the layer {layer} is used, which has no alpha", layer=layer.name or "RGB"))
    unused: list[str] = []
    for each in layers:
        if each is layer:
            unused += [name for name, index in each.others if index not in colour]
        elif each.colour:
            unused.append(each.name or "RGBA")
        elif not (layer.lends_alpha and each.subimage == layer.subimage and each.alpha == layer.alpha):
            unused += [name for name, _ in each.others] or [each.name or "A"]
    return (*notes, *not_used([*unused, *deep]))


def _exr_colours(spec: oiio.ImageSpec) -> tuple[ColourChange | None, tuple[Message, ...]]:
    """Return the change of an OpenEXR file's light to that of sRGB, and what is said of its colours."""
    given = spec.getattribute("chromaticities")
    if given is not None and len(given) == 8:
        rx, ry, gx, gy, bx, by, wx, wy = map(float, given)
        return light_change((rx, ry, gx, gy, bx, by, wx, wy)), ()
    for key in ("colorInteropID", "oiio:ColorSpace"):
        name = spec.get_string_attribute(key)
        known = primaries_called(name)
        if known is not None:
            return light_change(known), ()
        if name and not is_known_as_linear(name):
            return None, (
                Message("its colours are taken as linear light of Rec. 709, though it calls them {name}", name=name),
            )
    return None, ()


def _channels(kind: str, spec: oiio.ImageSpec) -> tuple[tuple[int, ...], int | None, tuple[Message, ...]]:
    """Return which channels are colour, which is alpha, and a note where the file does not say so."""
    count = spec.nchannels
    known = spec.alpha_channel if 0 <= spec.alpha_channel < count else None
    photometric = spec.get_int_attribute("tiff:PhotometricInterpretation", -1) if kind == "tiff" else -1
    is_gray = count <= 2 or photometric in {0, 1}
    colours = 1 if is_gray else 3
    colour = tuple(index for index in range(count) if index != known)[:colours]
    if known is not None or count <= colours:
        return colour, known, ()
    if kind == "targa":
        return colour, colours, ()
    return colour, colours, (_EXTRA_OF_GRAY if is_gray else _EXTRA_AS_ALPHA,)


def _unused_channels(spec: oiio.ImageSpec, used: tuple[int | None, ...]) -> tuple[Message, ...]:
    return not_used([name for index, name in enumerate(spec.channelnames) if index not in used])


def _is_for_pillow(kind: str, spec: oiio.ImageSpec) -> bool:
    """Return whether what this decoder leaves out is there with the other: an alpha beside a palette, inks' profile."""
    if kind == "tiff" and spec.get_int_attribute("tiff:PhotometricInterpretation", -1) == _PALETTE:
        return bool(spec.alpha_channel >= 0)
    if kind == "jpeg" and spec.format.size() > 1:
        return True  # expanded by its gain map; the picture itself is wanted
    ink = spec.get_string_attribute(f"{kind}:ColorSpace") in {"CMYK", "YCCK"}
    return ink and spec.format.size() == 1


def _dtype(spec: oiio.ImageSpec) -> str:
    base = spec.format.basetype
    return _DELIVERED.get(base, "uint16")


def _bits(spec: oiio.ImageSpec) -> int:
    return int(spec.get_int_attribute("oiio:BitsPerSample", spec.format.size() * 8))


def _in_colour(path: Path, spec: oiio.ImageSpec, header: Header) -> Header:
    """Return a header of integers or floats with the change of its colours to sRGB."""
    found: ColourChange | Message | None = None
    has_profile = True
    if header.format == "png":
        try:
            chunks = png_chunks(path)
        except OSError as error:
            raise input_problem(path, error) from error
        found, has_profile = chunks.colour_change(), chunks.has_profile
    profile: Any = spec.getattribute("ICCProfile") if has_profile else None
    if profile is not None:
        data = bytes(np.asarray(profile, np.uint8))
        found = change_by_profile(data, is_gray=len(header.colour) == 1)
    elif header.format == "jpeg" and spec.get_string_attribute("Exif:InteroperabilityIndex") == "R03":
        found = light_change(_ADOBE_RGB, power_curves(_ADOBE_GAMMA))
    if isinstance(found, Message):
        return replace(header, notes=(*header.notes, found))
    return replace(header, change=found)
