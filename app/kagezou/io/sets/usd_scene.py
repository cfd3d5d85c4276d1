"""What a USD stage shows on its first frame, as triangles: meshes, solids and instances that are drawn in a picture."""

from collections import Counter
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np

from kagezou.geometry.vectors import Matrix
from kagezou.io.files.faults import input_problem
from kagezou.io.sets.polygons import triangulated
from kagezou.io.sets.triangle_count import too_many
from kagezou.io.sets.triangles import Triangles, joined
from kagezou.io.sets.usd_notes import (
    EMPTY_INSTANCER,
    GUIDE,
    MISSING_PROTOTYPE,
    PROXY,
    SEEN_ANIMATED,
    notes_of_stage,
    notes_of_walk,
)
from kagezou.io.sets.usd_skins import posed_by_skeletons
from kagezou.io.sets.usd_solids import solid_of
from kagezou.io.sets.usd_stage import OpenStage, numbers_of, pxr
from kagezou.message import Message

_MAX_NESTED: Final = 16
_MAX_PRIMS: Final = 2_000_000


def triangles_in(opened: OpenStage, most: int) -> Triangles:
    """Return the triangles of a stage, each where it stands on the first frame.

    Raises
    ------
    InputProblem
        A mesh of it is damaged, or it has more than ``most`` triangles.
    """
    skins = posed_by_skeletons(opened)
    walk = _Walk(opened, most)
    found = walk.below(opened.stage.GetPseudoRoot(), np.eye(4))
    notes = (*opened.notes, *found.notes, *notes_of_walk(walk.left_out), *skins, *notes_of_stage(opened.stage))
    return Triangles(found.points, found.corners, tuple(dict.fromkeys(notes)))


@dataclass(slots=True)
class _Walk:
    """A walk through the prims of a stage; ``left_out`` counts what is not used, by why or by kind."""

    opened: OpenStage
    most: int
    left_out: Counter[str] = field(default_factory=Counter)
    prototypes: dict[str, Triangles] = field(default_factory=dict)
    nested: list[str] = field(default_factory=list)
    total: int = 0
    prims: int = 0

    def below(self, start: Any, matrix: Matrix) -> Triangles:
        """Return all that is drawn of a prim whose own place is (4, 4), acting on rows, and of what hangs on it."""
        predicate = pxr("Usd").TraverseInstanceProxies()
        waiting, made = [(start, matrix, False)], list[Triangles]()
        while waiting:
            prim, place, moves = waiting.pop()
            self.prims += 1
            if self.prims > _MAX_PRIMS:
                raise input_problem(self.opened.path, Message("it has more than {most} prims", most=_MAX_PRIMS))
            if self._is_hidden(prim):
                continue
            if pxr("UsdGeom").PointInstancer(prim):
                self.left_out[SEEN_ANIMATED] += moves
                made.append(self._instances(prim, place))
                continue
            own = self._shape(prim)
            if own is not None:
                self.left_out[SEEN_ANIMATED] += moves
                self.count(len(own.corners))
                made.append(_moved(own, place))
            children = prim.GetFilteredChildren(predicate)
            waiting += [(child, *self._place(child, place, moves)) for child in reversed(children)]
        return joined(made)

    def count(self, triangles: int) -> None:
        """Add to what will be there in the end; InputProblem where that is too much."""
        self.total += triangles
        if self.total > self.most:
            raise too_many(self.opened.path, self.total, self.most)

    def _place(self, prim: Any, above: Matrix, moves: bool) -> tuple[Matrix, bool]:  # noqa: FBT001 - a value
        """Return where a prim stands, and whether it moves, on something that is there and may move."""
        xformable = pxr("UsdGeom").Xformable(prim)
        if not xformable:
            return above, moves
        local, own = np.asarray(xformable.GetLocalTransformation(self.opened.time)), self._moves(xformable)
        return (local, own) if xformable.GetResetXformStack() else (np.asarray(local @ above), moves or own)

    def _moves(self, xformable: Any) -> bool:
        seen = xformable.GetVisibilityAttr()
        return bool(xformable.TransformMightBeTimeVarying() or seen.ValueMightBeTimeVarying())

    def _is_hidden(self, prim: Any) -> bool:
        """Whether a prim and all that hangs on it is invisible."""
        imageable = pxr("UsdGeom").Imageable(prim)
        if not imageable:
            return False
        seen = imageable.GetVisibilityAttr()
        is_hidden = bool(seen.Get(self.opened.time) == pxr("UsdGeom").Tokens.invisible)
        self.left_out[SEEN_ANIMATED] += is_hidden and seen.ValueMightBeTimeVarying()
        return is_hidden

    def _shape(self, prim: Any) -> Triangles | None:
        """Return what a prim itself draws, where it is modelled; None for nothing."""
        if not pxr("UsdGeom").Gprim(prim):
            if prim.GetTypeName() in ("Volume", "GenerativeProcedural"):
                self.left_out[prim.GetTypeName()] += 1
            return None
        purpose = str(pxr("UsdGeom").Imageable(prim).ComputePurpose())
        if purpose in (GUIDE, PROXY):
            self.left_out[purpose] += 1
            return None
        if pxr("UsdGeom").Mesh(prim):
            return self._mesh(prim)
        try:
            solid = solid_of(str(prim.GetTypeName()), lambda name: prim.GetAttribute(name).Get(self.opened.time))
        except (TypeError, ValueError, KeyError) as error:  # a measure that is no number, an axis that there is none of
            raise input_problem(self.opened.path, Message("it cannot be read as USD: the file is damaged")) from error
        if solid is None:
            self.left_out[str(prim.GetTypeName()) or "?"] += 1
        return solid

    def _mesh(self, prim: Any) -> Triangles | None:
        mesh, time = pxr("UsdGeom").Mesh(prim), self.opened.time
        attributes = mesh.GetPointsAttr(), mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr()
        if any(each.ValueMightBeTimeVarying() for each in attributes):
            self.left_out[SEEN_ANIMATED] += 1
        points, counts, corners = (numbers_of(self.opened.path, each, time) for each in attributes)
        if not len(counts) or not len(points):
            return None
        if counts.min() < 0 or counts.sum() != len(corners) or corners.min(initial=0) < 0:
            raise input_problem(self.opened.path, Message("it is damaged: a triangle names a missing corner"))
        if corners.max(initial=-1) >= len(points):
            raise input_problem(self.opened.path, Message("it is damaged: a triangle names a missing corner"))
        if int(np.maximum(counts.astype(np.int64) - 2, 0).sum()) > self.most - self.total:
            self.count(int(np.maximum(counts.astype(np.int64) - 2, 0).sum()))
        holes = numbers_of(self.opened.path, mesh.GetHoleIndicesAttr(), time).astype(np.int64)
        is_face = np.ones(len(counts), bool)
        is_face[holes[(holes >= 0) & (holes < len(counts))]] = False
        corners = corners[np.repeat(is_face, counts)].astype(np.int64)
        return triangulated(points.reshape(-1, 3).astype(np.float64), counts[is_face].astype(np.int64), corners)

    def _instances(self, prim: Any, place: Matrix) -> Triangles:
        """Return what a point instancer puts: each prototype as often as it says, none of them by itself."""
        instancer, time = pxr("UsdGeom").PointInstancer(prim), self.opened.time
        purpose = str(pxr("UsdGeom").Imageable(prim).ComputePurpose())
        kinds = numbers_of(self.opened.path, instancer.GetProtoIndicesAttr(), time).astype(np.int64)
        targets = instancer.GetPrototypesRel().GetForwardedTargets()
        if purpose in (GUIDE, PROXY) or not len(kinds) or not targets:
            self.left_out[purpose if purpose in (GUIDE, PROXY) else EMPTY_INSTANCER] += 1
            return joined([])
        if instancer.GetPositionsAttr().ValueMightBeTimeVarying():
            self.left_out[SEEN_ANIMATED] += 1
        if len(kinds) > self.most:
            raise too_many(self.opened.path, len(kinds), self.most)
        places = self._places(instancer, len(kinds))
        mask = list(instancer.ComputeMaskAtTime(time))
        kinds = kinds[np.array(mask, bool)] if len(mask) == len(kinds) else kinds
        if len(places) != len(kinds) or kinds.min(initial=0) < 0 or kinds.max(initial=-1) >= len(targets):
            raise input_problem(self.opened.path, Message("it is damaged: an instancer names what is not there"))
        made = []
        for number in np.unique(kinds).tolist():
            shape = self._prototype(self.opened.stage.GetPrimAtPath(targets[number]))
            own = places[kinds == number] @ place
            self.count(len(shape.corners) * len(own))
            made.append(_repeated(shape, own))
        return joined(made)

    def _places(self, instancer: Any, count: int) -> Matrix:
        found = instancer.ComputeInstanceTransformsAtTime(self.opened.time, self.opened.time)
        places = np.asarray(found, np.float64).reshape(-1, 4, 4)
        if len(places) > count:
            raise input_problem(self.opened.path, Message("it is damaged: an instancer names what is not there"))
        return places

    def _prototype(self, prim: Any) -> Triangles:
        """Return what a prototype draws in its own place; what stands where it is modelled counts for nothing."""
        if not prim:
            self.left_out[MISSING_PROTOTYPE] += 1
            return joined([])
        name = str(prim.GetPath())
        if name in self.nested or len(self.nested) > _MAX_NESTED:
            raise input_problem(self.opened.path, Message("it is damaged: instances are made of themselves"))
        if name not in self.prototypes:
            total = self.total
            self.nested.append(name)
            self.prototypes[name] = self.below(prim, np.eye(4))
            self.nested.pop()
            self.total = total
        return self.prototypes[name]


def _moved(shape: Triangles, place: Matrix) -> Triangles:
    """Return a shape moved by a place, which acts on rows."""
    return Triangles(shape.points @ place[:3, :3] + place[3, :3], shape.corners, shape.notes)


def _repeated(shape: Triangles, places: Matrix) -> Triangles:
    """Return a shape at every one of places (K, 4, 4)."""
    points = shape.points @ places[:, :3, :3] + places[:, 3:, :3]
    starts = len(shape.points) * np.arange(len(places))[:, np.newaxis, np.newaxis]
    return Triangles(points.reshape(-1, 3), (shape.corners + starts).reshape(-1, 3), shape.notes)
