"""What meshes do to a face that is no mesh: they hide parts of it, and take the light of others."""

from dataclasses import dataclass, replace

import numpy as np

from kagezou.geometry.box import Box
from kagezou.geometry.sets.faces_seen import Face
from kagezou.geometry.sets.round_faces_seen import RoundFace
from kagezou.geometry.vectors import Matrix
from kagezou.render.gpu.boxes import Boxes
from kagezou.render.gpu.program import Variants
from kagezou.render.gpu.targets import Format, Target, Texture
from kagezou.render.meshes.eye_view import MAP_UNIT, PAST_UNIT, TRIANGLES_UNIT, MeshView
from kagezou.render.meshes.light_map import LightMap
from kagezou.render.prepare.mask_tiles import Flags, MaskStates
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.shadow_tiles import TILE_PX, whole_grid
from kagezou.render.prepare.uniforms import Uniform

_NO_SHIFT = np.zeros(3)


@dataclass(frozen=True, slots=True, eq=False)
class Past:
    """Which parts of each pixel of a face no mesh hides.

    Parameters
    ----------
    texture
        That, of the canvas' size; None where no mesh is before the face.
    touched, hidden
        (rows, columns): in which tiles of the canvas a mesh may be before it, and in which ones nothing is left of it.
    """

    texture: Texture | None
    touched: Flags
    hidden: Flags


@dataclass(frozen=True, slots=True, eq=False)
class Screen:
    """What meshes do to one face under one light.

    Parameters
    ----------
    face, view
        The face, and the meshes.
    past
        What is seen of it.
    light_map
        What the light sees of the meshes that take it; None for none.
    """

    face: Face | RoundFace
    view: MeshView
    past: Past
    light_map: LightMap | None

    @property
    def switches(self) -> frozenset[str]:
        """Switches of ``sets/mask.frag``; a round face has asked for the light itself."""
        asks_light = isinstance(self.face, Face)
        past = frozenset() if self.past.texture is None else frozenset({"PAST_MESHES"})
        return past | self.light_map.switches if self.light_map is not None and asks_light else past

    def narrowed(self, states: MaskStates, box: Box) -> MaskStates:
        """Return the states of the tiles of a box with what the meshes change."""
        rows = slice(box.top // TILE_PX, -(-box.bottom // TILE_PX))
        columns = slice(box.left // TILE_PX, -(-box.right // TILE_PX))
        touched, hidden = (flags[rows, columns].ravel() for flags in (self.past.touched, self.past.hidden))
        touched = touched | self._may_be_dark(box)
        return replace(states, whole=states.whole & ~touched, edge=(states.edge | states.whole & touched) & ~hidden)

    def uniforms(self, origin_px: tuple[float, float]) -> dict[str, Uniform]:
        """Return what ``sets/mask.frag`` wants beyond the mask; its textures are bound."""
        found: dict[str, Uniform] = {}
        if self.past.texture is not None:
            self.past.texture.bind(PAST_UNIT)
            found["u_past"] = PAST_UNIT
        if self.light_map is not None and isinstance(self.face, Face):
            shift = np.array([[1.0, 0.0, origin_px[0]], [0.0, 1.0, origin_px[1]], [0.0, 0.0, 1.0]])
            lift = self._local_lift(self.face) @ shift
            found |= light_uniforms(self.light_map, self.view, _NO_SHIFT)
            found["u_lift_rows"] = np.column_stack([lift / max(abs(float(lift[3, 2])), 1e-9), np.zeros(4)])
            found["u_normal"] = self.face.flat.equation[:3]
        return found

    def may_be_taken(self, box: Box) -> Flags:
        """Return in which tiles of a box (N,) the meshes may take light from the face."""
        return self._may_be_dark(box)

    def _may_be_dark(self, box: Box) -> Flags:
        grid = whole_grid(box)
        count = grid.codes.size
        if self.light_map is None or isinstance(self.face, RoundFace):
            return np.zeros(count, bool)
        seen = self._local_lift(self.face) @ grid.corners()
        w = seen[:, 3]
        is_bounded = (w > 1e-9 * np.abs(w).max()).all(axis=0)
        points = seen[:, :3] / np.where(w > 0, w, 1.0)[:, np.newaxis]
        return np.asarray(~is_bounded | self.light_map.windows.may_hold(points))

    def _local_lift(self, face: Face) -> Matrix:
        lift = face.flat.lift.copy()
        lift[:3] -= np.outer(self.view.on_gpu.origin, lift[3])
        return lift


def light_uniforms(light_map: LightMap, view: MeshView, shift: Matrix) -> dict[str, Uniform]:
    """Return what ``meshes/light.glsl`` wants, its textures bound."""
    light_map.target.texture.bind(MAP_UNIT)
    view.on_gpu.texture.bind(TRIANGLES_UNIT)
    return light_map.uniforms(shift)


class Pasts:
    """Draws how much of each face no mesh hides; kept while neither moves."""

    def __init__(self, boxes: Boxes) -> None:
        self._boxes = boxes
        self._programs = Variants("common/box.vert", "meshes/past.frag")
        self._of: tuple[MeshView, SetAsSeen] | None = None
        self._kept: dict[int, Past] = {}

    def close(self) -> None:
        """Give the memory back."""
        self.forget()
        self._programs.close()

    def forget(self) -> None:
        """Give back what is kept."""
        for past in self._kept.values():
            if past.texture is not None:
                past.texture.close()
        self._kept.clear()
        self._of = None

    def past(self, view: MeshView, set_seen: SetAsSeen, face: Face | RoundFace) -> Past:
        """Return how much of a face of a set_seen no mesh hides."""
        if self._of is None or self._of[0] is not view or self._of[1] is not set_seen:
            self.forget()
            self._of = (view, set_seen)
        past = self._kept.get(id(face))
        if past is None:
            past = self._kept[id(face)] = self._drawn(view, face)
        return past

    def _drawn(self, view: MeshView, face: Face | RoundFace) -> Past:
        shape = view.ranges.shape[:2]
        touched, hidden = np.zeros(view.seen.shape, bool), np.zeros(view.seen.shape, bool)
        touched[view.seen] = True
        if isinstance(face, Face):
            heights = view.local_form(np.array(face.flat.equation)) @ view.hulls
            touched[view.seen] = heights.max(axis=0) > -1.0
            hidden[view.seen] = heights.min(axis=0) > 1.0
            hidden &= view.filled
        texture = self._texture(view, face) if touched.any() else None
        return Past(texture, touched.reshape(shape), hidden.reshape(shape))

    def _texture(self, view: MeshView, face: Face | RoundFace) -> Texture:
        target = Target(view.canvas.width, view.canvas.height, Format.ALPHA16)
        target.bind()
        view.bind()
        uniforms = view.uniforms()
        if isinstance(face, Face):
            switches: frozenset[str] = frozenset()
            uniforms["u_face"] = view.local_form(np.array(face.flat.equation))
        else:
            switches = frozenset({"ROUND"})
            uniforms |= {
                "u_centre": face.centre - view.on_gpu.origin,
                "u_across": face.across,
                "u_radius": face.shape.radius_px,
            }
        self._programs[switches].use({"u_target_size_px": target.size_px, **uniforms})
        self._boxes.draw_one(face.box)
        return target.texture_alone()
