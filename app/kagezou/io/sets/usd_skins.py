"""Skinned meshes and blend shapes of a USD stage, posed as on its first frame."""

from typing import Any

from kagezou.io.sets.usd_stage import OpenStage, pxr
from kagezou.message import Message


def posed_by_skeletons(opened: OpenStage) -> tuple[Message, ...]:
    """Pose what hangs on skeletons, in memory alone, and return what is to be said of it."""
    UsdSkel, stage = pxr("UsdSkel"), opened.stage  # noqa: N806 - a module
    roots = [prim for prim in stage.Traverse(pxr("Usd").TraverseInstanceProxies()) if UsdSkel.Root(prim)]
    if not roots:
        return ()
    stage.SetEditTarget(stage.GetSessionLayer())
    posed = [_is_posed(UsdSkel, root, opened.time) for root in roots]
    if all(posed):
        return (Message("its skins are posed as on its first frame"),)
    return (Message("{count} of its skins stand as they were modelled, without their pose", count=posed.count(False)),)


def _is_posed(skeletons: Any, root: Any, time: Any) -> bool:
    """Pose one tree of skinned meshes; whether that could be done, which it cannot within instances."""
    if root.IsInstanceProxy() or root.IsInstance():
        return False
    interval = pxr("Gf").Interval(time.GetValue() if not time.IsEarliestTime() else 0.0)
    try:
        return bool(skeletons.BakeSkinning(skeletons.Root(root), interval))
    except pxr("Tf").ErrorException:
        return False
