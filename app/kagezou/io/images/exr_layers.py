"""Layers of an OpenEXR file: colour and alpha of a picture come from one of them, never from several."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

_BEAUTY: Final = (
    "", "rgba", "rgb", "beauty", "combined", "composite", "comp", "color", "colour", "main", "image", "master", "final",
    "c", "default", "left",
)  # fmt: skip
"""What programs call the picture itself, the likeliest first; in small letters, by the last word of the name."""

_PLACES: Final = {"r": "r", "red": "r", "g": "g", "green": "g", "b": "b", "blue": "b", "a": "a", "alpha": "a"}
_GRAY: Final = frozenset({"y", "l", "luminance"})


@dataclass(frozen=True, slots=True)
class ExrLayer:
    """A layer: some channels of one part of the file.

    Parameters
    ----------
    name
        Of the layer, as the file has it; empty for channels without one.
    subimage
        The part it is in, from 0.
    colour
        Indices of its red, green and blue among the channels of the part; one of gray, or none.
    alpha
        Index of its alpha, None where it has none.
    others
        The names and indices of its channels that are no colour and no alpha.
    lends_alpha
        Whether the alpha is that of the part's unnamed layer, as it has none of its own.
    """

    name: str
    subimage: int
    colour: tuple[int, ...]
    alpha: int | None
    others: tuple[tuple[str, int], ...]
    lends_alpha: bool = False

    @property
    def is_picture(self) -> bool:
        """Whether there is a colour or an alpha in it."""
        return bool(self.colour) or self.alpha is not None


def layers_in(parts: Iterable[tuple[int, str, Sequence[str]]]) -> tuple[ExrLayer, ...]:
    """Return the layers of a file in its order.

    Parameters
    ----------
    parts
        Of each part that is flat: its place in the file, its name, and the names of its channels.
    """
    found: list[ExrLayer] = []
    for subimage, part, channels in parts:
        groups: dict[str, dict[str, int]] = defaultdict(dict)
        for index, channel in enumerate(channels):
            layer, _, place = channel.rpartition(".")
            groups[layer][place] = index
        own = [_layer(_joined(part, name), subimage, places) for name, places in groups.items()]
        unnamed = next((each.alpha for each in own if each.name == _joined(part, "")), None)
        found += [_lent(each, unnamed) for each in own]
    return tuple(found)


def chosen_layer(layers: Sequence[ExrLayer]) -> ExrLayer | None:
    """Return the layer that is the picture itself: by its name, else the first in colour, else the first of any kind.

    None where there is no channel at all.
    """
    coloured = [each for each in layers if len(each.colour) == 3]
    for candidates in (coloured, [each for each in layers if each.is_picture], list(layers)):
        if candidates:
            return min(candidates, key=lambda each: _rank(each.name))
    return None


def _rank(name: str) -> int:
    plain = name.casefold()
    word = plain.replace("/", ".").rpartition(".")[2]
    return next((_BEAUTY.index(each) for each in (plain, word) if each in _BEAUTY), len(_BEAUTY))


def _joined(part: str, layer: str) -> str:
    """Return the name of a layer within a part; parts of files of one part, and those named like it, have no say."""
    if not part or layer == part or layer.startswith(f"{part}."):
        return layer
    return f"{part}.{layer}" if layer else part


def _layer(name: str, subimage: int, places: dict[str, int]) -> ExrLayer:
    known: dict[str, int] = {}
    for place, index in places.items():
        if (kind := _PLACES.get(place.casefold())) is not None:
            known.setdefault(kind, index)
    colour: tuple[int, ...] = ()
    if {"r", "g", "b"} <= set(known):
        colour = known["r"], known["g"], known["b"]
    else:
        gray = next((index for place, index in places.items() if place.casefold() in _GRAY), None)
        # Beside an x it is a direction or a place.
        gray = None if {"x", "X"} & set(places) else gray
        colour = () if gray is None else (gray,)
    used = {*colour, known.get("a")}
    others = tuple(
        (f"{name}.{place}" if name else place, index) for place, index in places.items() if index not in used
    )
    return ExrLayer(name, subimage, colour, known.get("a"), others)


def _lent(layer: ExrLayer, unnamed: int | None) -> ExrLayer:
    """Return a layer in colour without alpha with that of the unnamed layer of its part, where there is one."""
    if not layer.colour or layer.alpha is not None or unnamed is None:
        return layer
    return ExrLayer(layer.name, layer.subimage, layer.colour, unnamed, layer.others, lends_alpha=True)
