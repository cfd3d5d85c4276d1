"""How a shadow changes over its receiver, as ``common/look.glsl`` wants it."""

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.targets import Texture
from kagezou.render.prepare.uniforms import Uniform
from kagezou.scene.scene import ShadowCast, ShadowLook

Rgb = tuple[float, float, float]


DISTANCE_UNIT = 3
"""The texture unit of a picture of distances."""


def look_uniforms(
    cast: ShadowCast | None, look: ShadowLook, box: Box, distances: Texture | None = None
) -> tuple[frozenset[str], dict[str, Uniform]]:
    """Return the switches of ``common/look.glsl`` and its uniforms for a part of the canvas.

    A shadow without a cast, that of the set itself, has no contact line to fade from. On a set ``distances`` tell how
    far from it each pixel is; they are bound.
    """
    switches: set[str] = set()
    uniforms: dict[str, Uniform] = {"u_opacity": look.opacity}
    if look.fade is not None:
        switches.add("FADING")
        uniforms |= {"u_fade_px": look.fade.range_px, "u_fade_curve": look.fade.curve}
    if look.tip is not None:
        switches.add("TINTED")
        uniforms |= {"u_tip_color": unit_rgb(look.tip.color), "u_tip_px": look.tip.distance_px}
    if switches and cast is not None:
        plane = contact_plane(cast.card, cast.receivers[0])
        plane_from_canvas = np.linalg.inv(canvas_from_plane(cast.camera, plane))
        uniforms |= distance_uniforms(plane_from_canvas[1], plane_from_canvas[2], box)
        if distances is not None:
            switches.add("MEASURED")
            distances.bind(DISTANCE_UNIT)
            uniforms["u_distances"] = DISTANCE_UNIT
    return frozenset(switches), uniforms


def unit_rgb(color: tuple[int, int, int]) -> Rgb:
    """Return an 8 bit colour as numbers from 0 to 1."""
    red, green, blue = color
    return (red / 255, green / 255, blue / 255)


def distance_uniforms(away: Matrix, lift: Matrix, box: Box) -> dict[str, Uniform]:
    """Return forms (3,) over the canvas whose quotient is a distance as shaders want them, for a part of the canvas."""
    origin = ((box.left + box.right) // 2 + 0.5, (box.top + box.bottom) // 2 + 0.5)
    shift = np.array([[1.0, 0.0, origin[0]], [0.0, 1.0, origin[1]], [0.0, 0.0, 1.0]])
    forms = np.array([away, lift]) @ shift
    forms = forms / np.abs(forms[1]).max()
    return {"u_origin_px": origin, "u_away": forms[0], "u_lift": forms[1]}
