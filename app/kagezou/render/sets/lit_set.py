"""What the pass of sets works with: a set under one light, a filtered shadow, and how dark a face is of its own."""

from dataclasses import dataclass, field

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.polygon import box_polygon, clipped, distance_form, shifted
from kagezou.geometry.sets.faces_seen import Face
from kagezou.geometry.sets.occlusion_cones import Occlusion
from kagezou.geometry.sets.regions import Group, Region
from kagezou.geometry.shadow import plane_coordinates
from kagezou.geometry.vectors import Vector4
from kagezou.render.gpu.targets import Target
from kagezou.render.meshes.mesh_pass import MeshLit
from kagezou.render.passes.silhouette import Silhouette
from kagezou.render.prepare.cast_uniforms import FULL_STRENGTH, Frame, Grazing
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.sets.add_face import OwnShade

EVERYWHERE = Group((Region(np.zeros((0, 3))),), overlaps=False)
"""What a face that is turned away from the light loses of it."""


@dataclass(frozen=True, slots=True, eq=False)
class Lit:
    """A set under one light: who keeps it from whom."""

    set_seen: SetAsSeen
    light: Vector4
    occlusions: dict[int, Occlusion]
    meshes: MeshLit | None


@dataclass(slots=True)
class Shaped:
    """A filtered shadow.

    Parameters
    ----------
    faces
        As it lies on flat faces, on each as if nothing else were there.
    silhouette
        What casts it on all others; None for the drawing itself.
    """

    faces: dict[Face, tuple[Target, Box | None]] = field(default_factory=dict)
    silhouette: Silhouette | None = None


def own_shade(face: Face, light: Vector4 | None, box: Box) -> OwnShade:
    """Return how strong the set's shadow is on a face under a light; without one, at its full strength."""
    frame = Frame(clipped(box_polygon(box), shifted(distance_form(face.flat.lift[3]), -0.01)))
    grazing = FULL_STRENGTH if light is None else Grazing.of(face.plane, light)
    receiver_from_canvas = plane_coordinates(face.plane) @ face.flat.lift
    switches = grazing.switches(receiver_from_canvas, frame)
    x, y = (float(each) for each in frame.origin)
    uniforms = {"u_origin_px": (x, y), **grazing.uniforms(receiver_from_canvas, frame)}
    return OwnShade(switches, uniforms, is_even=not switches and uniforms["u_strength"] == 1.0)
