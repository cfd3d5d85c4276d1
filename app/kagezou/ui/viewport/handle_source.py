"""The handles there are now, for whoever paints or takes hold of them."""

from enum import Enum

from kagezou.geometry.vectors import Point2
from kagezou.tools.handle import Handle, HandleSet
from kagezou.tools.handles import cel_mover, handles_of, matching_handles_of, placing_handles_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.viewport.viewpoint import Viewpoint


class Task(Enum):
    """What the hand on the picture is for."""

    SCENE = "light, ground, feet and set"
    MATCH = "lines by which the camera is matched"
    TRANSFORM = "a cel that is moved, scaled and turned"


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
        self.task = Task.SCENE

    @property
    def handles(self) -> HandleSet:
        """Those of the task: of the layer or set piece worked on, of the camera's match, or of the cel."""
        bridge, view = self._bridge, self._viewpoint.view
        document, frame = bridge.document, bridge.frame
        layer_id = self._layer_id
        made_of = (document, frame, layer_id, bridge.piece_id, view, self.task)
        if not self._made_of or self._made_of[0] is not document or self._made_of[1:] != made_of[1:]:
            match self.task:
                case Task.MATCH:
                    self._handles = matching_handles_of(document, frame, view)
                case Task.TRANSFORM:
                    self._handles = placing_handles_of(document, frame, layer_id, view)
                case Task.SCENE:
                    self._handles = handles_of(document, frame, layer_id, view, bridge.piece_id)
            self._made_of = made_of
        return self._handles

    @property
    def _layer_id(self) -> str | None:
        """The layer whose handles there are: the one worked on, unless it or its figure is locked."""
        document, layer_id = self._bridge.document, self._bridge.layer_id
        if layer_id is None:
            return None
        layer = document.layer(layer_id)
        figure = document.layer(layer.joins or layer_id)
        return None if layer.marks.is_locked or figure.marks.is_locked else layer_id

    def behind(self, canvas_px: Point2) -> Handle | None:
        """Return what the hand takes hold of beside all handles: the cel itself while it is transformed."""
        if self.task is not Task.TRANSFORM:
            return None
        bridge = self._bridge
        return cel_mover(bridge.document, bridge.frame, self._layer_id, self._viewpoint.view, canvas_px)
