"""What of a USD stage is not used or had to be assumed."""

from collections import Counter
from collections.abc import Iterable
from itertools import islice
from typing import Any, Final

import numpy as np

from kagezou.io.sets.camera_poses import is_mirrored
from kagezou.io.sets.triangles import listed
from kagezou.io.sets.usd_stage import pxr
from kagezou.message import Message

GUIDE, PROXY = "guide", "proxy"
"""The purposes of what is not drawn in a finished picture."""

SEEN_ANIMATED: Final = "animated"
EMPTY_INSTANCER: Final = "empty instancer"
MISSING_PROTOTYPE: Final = "missing prototype"
_WORDS: Final = (GUIDE, PROXY, SEEN_ANIMATED, EMPTY_INSTANCER, MISSING_PROTOTYPE)
_MAX_PRIMS: Final = 200_000


def notes_of_walk(left_out: Counter[str]) -> tuple[Message, ...]:
    """Return what is said of the prims that were passed over, counted by why or by their kind."""
    notes = []
    if left_out[GUIDE]:
        notes.append(Message("{count} of its shapes are guides and are not used", count=left_out[GUIDE]))
    if left_out[PROXY]:
        notes.append(Message("{count} of its shapes are proxies for others and are not used", count=left_out[PROXY]))
    if left_out[SEEN_ANIMATED]:
        notes.append(Message("its shapes are animated: they are used as on its first frame"))
    if left_out[EMPTY_INSTANCER]:
        notes.append(Message("{count} of its instancers put nothing", count=left_out[EMPTY_INSTANCER]))
    if left_out[MISSING_PROTOTYPE]:
        notes.append(Message("{count} of its prototypes are missing", count=left_out[MISSING_PROTOTYPE]))
    kinds = [kind for kind in left_out.elements() if kind not in _WORDS]
    if kinds:
        notes.append(Message("its {kinds} are not used", kinds=listed(kinds)))
    return tuple(notes)


def notes_of_stage(stage: Any) -> tuple[Message, ...]:
    """Return what is said of variants, subdivision, mirrored cameras and the unit of a stage."""
    prims = list(islice(stage.Traverse(pxr("Usd").TraverseInstanceProxies()), _MAX_PRIMS))
    notes = [*_of_variants(prims), *_of_cages(prims), *_of_cameras(prims)]
    unit = float(pxr("UsdGeom").GetStageMetersPerUnit(stage))
    if pxr("UsdGeom").StageHasAuthoredMetersPerUnit(stage) and unit != 1.0:
        notes.append(Message("its unit is {unit:g} m; its size on the canvas does not follow from that", unit=unit))
    return tuple(notes)


def _of_variants(prims: Iterable[Any]) -> list[Message]:
    chosen = []
    for prim in prims:
        if not prim.HasVariantSets() or prim.IsInstanceProxy():
            continue
        sets = prim.GetVariantSets()
        for name in sets.GetNames():
            own = sets.GetVariantSet(name)
            if len(own.GetVariantNames()) > 1 or not own.GetVariantSelection():
                chosen.append(f"{name}={own.GetVariantSelection() or '-'}")
    return [Message("of its variants these are used: {names}", names=listed(chosen))] if chosen else []


def _of_cages(prims: Iterable[Any]) -> list[Message]:
    for prim in prims:
        scheme = prim.GetAttribute("subdivisionScheme") if prim.GetTypeName() == "Mesh" else None
        if scheme and scheme.HasAuthoredValue() and str(scheme.Get()) != "none":
            return [Message("its subdivision surfaces are used as their cages")]
    return []


def _of_cameras(prims: Iterable[Any]) -> list[Message]:
    cache = pxr("UsdGeom").XformCache(pxr("Usd").TimeCode.EarliestTime())
    mirrored = [
        prim.GetName()
        for prim in prims
        if prim.GetTypeName() == "Camera" and is_mirrored(np.asarray(cache.GetLocalToWorldTransform(prim)))
    ]
    return [Message("its cameras {names} are mirrored, which is not done", names=listed(mirrored))] if mirrored else []
