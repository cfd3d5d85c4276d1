"""The handles there are now, for whoever paints or takes hold of them."""

from kagezou.tools.handle import HandleSet
from kagezou.tools.handles import handles_of, matching_handles_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.viewpoint import Viewpoint


class HandleSource:
    """The handles of the frame, worked out anew only where something they depend on changed.

    Parameters
    ----------
    bridge
        The session worked in.
    viewpoint
        How the canvas is looked at.
    """

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint) -> None:
        self._bridge = bridge
        self._viewpoint = viewpoint
        self._made_of: tuple[object, ...] = ()
        self._handles = HandleSet()
        self.is_matching = False

    @property
    def handles(self) -> HandleSet:
        """Those of the layer or set piece worked on, or while the camera is matched, its lines instead of all else."""
        bridge, view = self._bridge, self._viewpoint.view
        document, frame = bridge.document, bridge.frame
        made_of = (document, frame, bridge.layer_id, bridge.piece_id, view, self.is_matching)
        if not self._made_of or self._made_of[0] is not document or self._made_of[1:] != made_of[1:]:
            if self.is_matching:
                self._handles = matching_handles_of(document, frame, view)
            else:
                self._handles = handles_of(document, frame, bridge.layer_id, view, bridge.piece_id)
            self._made_of = made_of
        return self._handles
