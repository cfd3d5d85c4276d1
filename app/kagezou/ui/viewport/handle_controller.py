"""The hand on the picture: which handle it is over, which it holds, and the gesture that its drag is."""

from dataclasses import dataclass

from PySide6.QtCore import QCoreApplication, QObject, Signal

from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.session.session import Gesture
from kagezou.tools.drag import Drag
from kagezou.tools.handle import Handle, HandleSet, hit
from kagezou.tools.handle_hints import hints_of
from kagezou.tools.handles import drag_of
from kagezou.tools.readout import readout, values
from kagezou.tools.set_piece import POSITION
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated
from kagezou.ui.viewport.handle_source import HandleSource, Task
from kagezou.ui.viewport.nudging import Nudging
from kagezou.ui.viewport.piece_touch import PieceTouch
from kagezou.ui.viewport.pointer_report import PointerReport
from kagezou.ui.viewport.typed_value import with_typed
from kagezou.ui.viewport.viewpoint import Viewpoint


@dataclass(frozen=True, slots=True)
class _Held:
    handle: Handle
    drag: Drag
    gesture: Gesture
    frame: int

    def words(self, document: Document, typed: str) -> str:
        """Return what is said of the values while it is dragged, or of what is typed."""
        if typed:
            return f"{translated(self.handle.label)}  {typed}"
        parts = readout(self.handle, self.gesture.start, document, self.frame)
        return "  ".join(map(translated, parts))

    def show_typed(self, typed: str) -> None:
        """Show the value that is typed, as far as it is one."""
        document = with_typed(self.handle, self.gesture.start, self.frame, typed)
        if document is not None:
            self.gesture.show(document)

    def let_go(self, *, keep: bool) -> None:
        """End the drag, as one step of history or as if it had not been."""
        self.drag.close()
        if keep:
            self.gesture.commit()
        else:
            self.gesture.cancel()


class HandleController(QObject):
    """Takes pointers and keys, shows documents through a gesture of the session, and says what to paint.

    Parameters
    ----------
    bridge
        The session worked in.
    viewpoint
        How the canvas is looked at.
    """

    changed = Signal()
    chosen = Signal()
    """Another handle is selected, or none."""
    refused = Signal(str)
    """What was asked for cannot be done, with the sentence that says why."""
    laid_down = Signal()
    """Escape while nothing was held: what the hand was given for a while may be put away."""

    def __init__(self, bridge: Bridge, viewpoint: Viewpoint) -> None:
        super().__init__()
        self._bridge = bridge
        self._viewpoint = viewpoint
        self._held: _Held | None = None
        self._nudging = Nudging(bridge, viewpoint)
        self._source = HandleSource(bridge, viewpoint)
        self.pieces = PieceTouch(bridge, viewpoint)
        self.hovered_id: str | None = None
        self._selected_id: str | None = None
        self.place_px: Point2 | None = None
        self.typed = ""
        bridge.session_replaced.connect(self._drop)
        bridge.selection_changed.connect(self._keep_to_what_is_there)

    @property
    def is_busy(self) -> bool:
        """Whether it holds a handle."""
        return self._held is not None

    @property
    def held(self) -> Handle | None:
        """The handle it holds, as it was when taken."""
        return self._held.handle if self._held else None

    @property
    def selected_id(self) -> str | None:
        """The handle that keys and commands are about."""
        return self._selected_id

    def select(self, handle_id: str | None) -> None:
        """Let keys and commands be about a handle, or none."""
        before, self._selected_id = self._selected_id, handle_id
        self.changed.emit()
        if handle_id != before:
            self.chosen.emit()

    def under(self, report: PointerReport) -> Handle | None:
        """Return the handle under the pointer."""
        return hit(self.handles.handles, self._viewpoint.view, report.view_px, report.reach_px, self._viewpoint.size)

    @property
    def handles(self) -> HandleSet:
        """The handles of the frame."""
        return self._source.handles

    @property
    def task(self) -> Task:
        """What the hand is for now."""
        return self._source.task

    def take_up(self, task: Task) -> None:
        """Put the handles of another task in the place of those there are."""
        if task is not self._source.task:
            self._let_go(keep=False)
            self._source.task = task
            self.hovered_id = None
            self.select(None)

    @property
    def words(self) -> str:
        """What stands beside the pointer: the values while dragging, else all about the handle under it."""
        if self._held is not None:
            note = self.handles.note
            return self._held.words(self._bridge.document, self.typed) if note is None else translated(note)
        hovered = self.handles.find(self.hovered_id)
        bridge = self._bridge
        return self.pieces.name if hovered is None else _about(hovered, bridge.document, bridge.frame)

    def hover(self, report: PointerReport | None) -> None:
        """Look what is under the pointer; None where it has left."""
        before = _touched(self)
        self.place_px = report.view_px if report else None
        found = self.under(report) if report else None
        self.hovered_id = found.id if found else None
        self.pieces.hover(None if found or self.task is not Task.SCENE else report)
        if _touched(self) != before:
            self.changed.emit()

    def press(self, report: PointerReport) -> bool:
        """Take hold of the handle under the pointer, or of the set piece whose outline it is on; false without any."""
        self.end_nudge()
        handle = self.under(report)
        if handle is None:
            handle = self._source.behind(self._viewpoint.view.canvas_from_view(report.view_px))
        if handle is None and self.task is Task.SCENE and self.pieces.choose(report):
            handle = self.handles.find(POSITION)
        # Before it is held: the gesture of a drag begins with what is chosen.
        self.select(handle.id if handle else None)
        if handle is not None:
            self._held = _taken(handle, self._bridge, self._viewpoint, report)
            self.place_px = report.view_px
            self.changed.emit()
        return handle is not None

    def move(self, report: PointerReport) -> None:
        """Go on with the drag."""
        self.place_px = report.view_px
        if self._held is not None and not self.typed:
            self._held.gesture.show(self._held.drag.send(report.pointer(self._viewpoint.view)))
            self.changed.emit()

    def type(self, typed: str) -> None:
        """Set the value of what is held by typed text; without any the hand goes on."""
        if self._held is not None:
            self.typed = typed
            self._held.show_typed(typed)
            self.changed.emit()

    def release(self) -> None:
        """Let go; the drag is one step of history."""
        self._let_go(keep=True)

    def cancel(self) -> bool:
        """Let go and restore what was; without a drag end the task there is, or let go of the selected handle.

        False where there was none of it.
        """
        if self._held is not None:
            self._let_go(keep=False)
        elif self.task is not Task.SCENE:
            self.laid_down.emit()
        elif self.selected_id is not None:
            self.select(None)
        else:
            return False
        return True

    def cycle(self, step: int) -> None:
        """Select the next handle in reading order, as Tab does."""
        ids = [handle.id for handle in self.handles.handles]
        if ids:
            self.select(_neighbour(ids, self.selected_id, step))

    def nudge(self, dx: float, dy: float) -> bool:
        """Move the selected handle by canvas px; steps until ``end_nudge`` are one step of history."""
        handle = self.handles.find(self.selected_id)
        if handle is None or self._held is not None:
            return False
        self._nudging.nudge(handle, dx, dy)
        return True

    def end_nudge(self) -> None:
        """Make the nudges so far one step."""
        self._nudging.end()

    def _let_go(self, *, keep: bool) -> None:
        held, self._held = self._held, None
        self.typed = ""
        if held is None:
            return
        held.let_go(keep=keep)
        self.changed.emit()

    def _drop(self) -> None:
        """Forget everything about a session that was put away."""
        self._held = None
        self._nudging.forget()
        self.hovered_id = None
        self.select(None)

    def _keep_to_what_is_there(self) -> None:
        self.select(None if self.handles.find(self.selected_id) is None else self.selected_id)


def _touched(hand: HandleController) -> tuple[object, ...]:
    """Return what is under the pointer, and if there is something, where the pointer is."""
    touched = (hand.hovered_id, hand.pieces.hovered_id)
    return (*touched, hand.place_px if any(touched) else None)


def _about(handle: Handle, document: Document, frame: int) -> str:
    """Return a handle's name and values, and on a second line what its drag takes note of."""
    first = (translated(handle.label), *map(translated, values(handle, document, frame)))
    return "  ".join(first) + "\n" + "   ".join(map(translated, hints_of(handle)))


def _taken(handle: Handle, bridge: Bridge, viewpoint: Viewpoint, report: PointerReport) -> _Held:
    """Take hold of a handle where the pointer is."""
    gesture = bridge.session.begin(
        QCoreApplication.translate("HandleController", "Move %1").replace("%1", translated(handle.label))
    )
    drag = drag_of(handle, gesture.start, bridge.frame, viewpoint.view)
    drag.send(report.pointer(viewpoint.view))
    return _Held(handle, drag, gesture, bridge.frame)


def _neighbour(ids: list[str], selected: str | None, step: int) -> str:
    """Return the id that lies so many steps from the selected one, around the end."""
    here = ids.index(selected) if selected in ids else (-1 if step > 0 else 0)
    return ids[(here + step) % len(ids)]
