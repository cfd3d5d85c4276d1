"""Steps of a handle by the arrow keys: those that follow each other are one step of history."""

from PySide6.QtCore import QCoreApplication

from kagezou.session.session import Gesture
from kagezou.tools.handle import Handle
from kagezou.tools.handles import nudge
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.viewpoint import Viewpoint


class Nudging:
    """Moves handles by small steps.

    Parameters
    ----------
    bridge
        The session worked in.
    viewpoint
        How the canvas is looked at.
    """

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint) -> None:
        self._bridge, self._viewpoint = bridge, viewpoint
        self._nudged: tuple[Handle, Gesture] | None = None

    def nudge(self, handle: Handle, dx: float, dy: float) -> None:
        """Move a handle by canvas px; steps of one handle until :meth:`end` are one step of history."""
        if self._nudged is None or self._nudged[0].id != handle.id:
            self.end()
            name = QCoreApplication.translate("HandleController", "Nudge %1").replace("%1", translated(handle.label))
            self._nudged = (handle, self._bridge.session.begin(name))
        view, frame = self._viewpoint.view, self._bridge.frame
        self._nudged[1].show(nudge(handle, self._bridge.document, frame, dx, dy, view))

    def end(self) -> None:
        """Make the steps so far one."""
        if self._nudged is not None:
            gesture = self._nudged[1]
            self.forget()
            gesture.commit()

    def forget(self) -> None:
        """Leave the steps so far to a session that was put away."""
        self._nudged = None
