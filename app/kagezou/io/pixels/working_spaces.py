"""Spaces of linear light that picture files name instead of giving their primaries."""

from typing import Final

from kagezou.io.pixels.colour_change import REC709, Chromaticities

_AP0: Final = (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, 0.32168, 0.33767)
_AP1: Final = (0.713, 0.293, 0.165, 0.830, 0.128, 0.044, 0.32168, 0.33767)
_REC2020: Final = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
_P3_D65: Final = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)
_ADOBE: Final = (0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.3290)
_SPACES: Final[dict[str, Chromaticities]] = {
    "acescg": _AP1,
    "aces-acescg": _AP1,
    "lin_ap1": _AP1,
    "lin_ap1_scene": _AP1,
    "aces2065-1": _AP0,
    "lin_ap0": _AP0,
    "lin_ap0_scene": _AP0,
    "lin_rec2020": _REC2020,
    "lin_rec2020_scene": _REC2020,
    "linear_rec.2020": _REC2020,
    "lin_p3d65": _P3_D65,
    "lin_p3d65_scene": _P3_D65,
    "linear_p3-d65": _P3_D65,
    "lin_adobergb": _ADOBE,
    "lin_adobergb_scene": _ADOBE,
    "lin_rec709": REC709,
    "lin_rec709_scene": REC709,
    "lin_srgb": REC709,
    "linear_rec.709_(srgb)": REC709,
    "linear": REC709,
    "scene_linear": REC709,
}
"""By what OpenColorIO's configurations and the interchange names of the Color Interop Forum call them."""

_NO_COLOURS: Final = frozenset({"data", "raw", "unknown"})


def primaries_called(name: str) -> Chromaticities | None:
    """Return the primaries and the white of the space of that name, None where it is not known."""
    return _SPACES.get(_plain(name))


def is_known_as_linear(name: str) -> bool:
    """Return whether a name says that there is nothing to change."""
    return _plain(name) in _NO_COLOURS or primaries_called(name) is REC709


def _plain(name: str) -> str:
    return name.strip().casefold().replace(" - ", "-").replace(" ", "_")
