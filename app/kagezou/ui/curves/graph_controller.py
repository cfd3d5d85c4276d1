"""The hand on the graph: choosing and dragging keys and handles, adding keys, and reading values off."""

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent

from kagezou.document.key_edits import Refs
from kagezou.document.model import Document
from kagezou.geometry.vectors import Point2
from kagezou.session.session import Gesture
from kagezou.tools.curves.box_drag import BoxDrag, DraggedBox, dragging_box
from kagezou.tools.curves.curve_drag import CurveDrag, CurveGrip, dragging_curve
from kagezou.tools.curves.graph_edits import with_key
from kagezou.tools.curves.graph_model import KEY_REACH_PX, GraphModel
from kagezou.tools.curves.graph_pointer import GraphPlace, GraphPointer
from kagezou.tools.curves.key_box import BoxGrip, KeyBox
from kagezou.tools.curves.picture import CurvePicture, GraphKind, HandleMark, KeyMark, Pictures
from kagezou.ui.curves.box_items import cursor_on
from kagezou.ui.curves.box_words import step_name, words_of
from kagezou.ui.curves.choice import Choice
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.shown_units import common_factor

_DRAG_PX = 4.0

_SHIFT = Qt.KeyboardModifier.ShiftModifier
_CONTROL = Qt.KeyboardModifier.ControlModifier
_ALT = Qt.KeyboardModifier.AltModifier


@dataclass(frozen=True, slots=True)
class HandShown:
    """What the hand lets be seen: a box around keys, two corners in graph coordinates, and words beside a widget px."""

    box: tuple[GraphPlace, GraphPlace] | None = None
    words: str = ""
    beside_px: Point2 = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class _BoxHeld:
    """The frame around keys, taken hold of by a part, and the curves as they were."""

    box: KeyBox
    part: BoxGrip
    pictures: Pictures


class GraphController(QObject):
    """What mouse and keyboard do on the graph; a drag is one step of history, and Esc takes it back.

    Parameters
    ----------
    bridge
        The session.
    choice
        What the graph shows.
    model
        Tells how it is seen now.
    """

    read = Signal(float, float)
    """The pointer is at this frame and ordinate."""
    left = Signal()
    exact_asked = Signal()
    """The selected key's speeds and influences shall be typed."""
    shown = Signal(object)
    """What is to be seen of the hand: a :class:`HandShown`."""
    drag_ended = Signal()
    """What was held while the hand moved fits anew."""

    def __init__(self, bridge: Bridge, choice: Choice, model: Callable[[], GraphModel]) -> None:
        super().__init__()
        self._bridge, self._choice, self._model = bridge, choice, model
        self._pressed: GraphPointer | None = None
        self._held: CurveGrip | _BoxHeld | None = None
        self._gesture: Gesture | None = None
        self._drag: CurveDrag | BoxDrag | None = None
        self._before: Refs = frozenset()
        self._adds = False
        self._scrubs = False

    @property
    def is_down(self) -> bool:
        """Whether the left button is down."""
        return self._pressed is not None

    @property
    def is_busy(self) -> bool:
        """Whether a drag goes on."""
        return self._gesture is not None

    def press(self, pointer: GraphPointer, modifiers: Qt.KeyboardModifier) -> None:
        """Take the left button going down."""
        self._pressed, place, model = pointer, pointer.place, self._model()
        self._adds = bool(modifiers & _SHIFT)
        self._before = self._bridge.session.state.keys
        if (handle := model.handle_at(place)) is not None:
            self._held = CurveGrip(*handle, self._before)
        elif (key := model.key_at(place)) is not None:
            self._choose(key[1])
            self._held = CurveGrip(*key, self._bridge.session.state.keys)
        elif (box := _box_under(model, place, modifiers)) is not None:
            self._held = box
        elif (picture := model.curve_at(place)) is not None:
            if modifiers & _CONTROL:
                self._add_key(picture, place)
            else:
                self._bridge.session.select_keys(frozenset(mark.ref for mark in picture.keys))
        else:
            self._scrubs = abs(place[0] - self._bridge.frame) <= KEY_REACH_PX / 2 * model.pixels[0]

    def move(self, pointer: GraphPointer) -> None:
        """Take a move with the left button down."""
        self.read.emit(*pointer.place)
        if self._pressed is None:
            return
        if self._scrubs:
            self._bridge.session.go_to(round(pointer.place[0]))
        elif self.is_busy or _is_far(self._pressed, pointer):
            self._go_on(self._pressed, pointer)

    def release(self, pointer: GraphPointer, modifiers: Qt.KeyboardModifier) -> None:
        """Take the left button coming up."""
        held, model = self._held, self._model()
        if self._gesture is not None:
            self._gesture.commit()
        elif isinstance(held, _BoxHeld) and held.part.is_inside:
            # A click within the frame is what it is without one.
            picture = model.curve_at(pointer.place)
            found = () if picture is None else picture.keys
            self._bridge.session.select_keys(frozenset(mark.ref for mark in found))
        elif not isinstance(held, CurveGrip) and not modifiers and self._is_on_nothing(pointer, model):
            self._bridge.session.select_keys(frozenset())
        self._let_go()

    def double_click(self, pointer: GraphPointer) -> None:
        """Ask for numbers on a key; elsewhere go to the frame."""
        if self._model().key_at(pointer.place) is not None:
            self.exact_asked.emit()
        else:
            self._bridge.session.go_to(round(pointer.place[0]))

    def hover(self, pointer: GraphPointer) -> Qt.CursorShape:
        """Take note of the pointer, and return what it looks like there."""
        self.read.emit(*pointer.place)
        model = self._model()
        if model.handle_at(pointer.place) is not None or model.key_at(pointer.place) is not None:
            return Qt.CursorShape.PointingHandCursor
        part = None if model.key_box is None else model.key_box.part_at(pointer.place)
        return Qt.CursorShape.CrossCursor if part is None else cursor_on(part)

    def leave(self) -> None:
        """Take note that the pointer is elsewhere."""
        self.left.emit()

    def wants(self, event: QKeyEvent) -> bool:
        """Return whether a key belongs to the hand, not to the window's commands."""
        if event.modifiers() & (_CONTROL | _ALT | _SHIFT):
            return False
        if event.key() == Qt.Key.Key_Escape:
            return self.is_down or bool(self._bridge.session.state.keys)
        return event.key() in (Qt.Key.Key_Left, Qt.Key.Key_Right)

    def key(self, event: QKeyEvent) -> bool:
        """Take a key going down; false if it is another one."""
        if not self.wants(event):
            return False
        if event.key() == Qt.Key.Key_Escape:
            self.cancel()
        else:
            self._bridge.session.go_to(self._bridge.frame + (1 if event.key() == Qt.Key.Key_Right else -1))
        return True

    def cancel(self) -> None:
        """Take a drag back; with none, select nothing."""
        if self._gesture is not None:
            self._gesture.cancel()
        else:
            self._bridge.session.select_keys(self._before if self.is_down else frozenset())
        self._let_go()

    def _go_on(self, pressed: GraphPointer, pointer: GraphPointer) -> None:
        held = self._held
        if held is None:
            self._draw_box(pressed.place, pointer.place)
            return
        if self._gesture is None or self._drag is None:
            self._gesture = self._bridge.session.begin(self._step_name(held))
            self._drag = self._begun(held, self._gesture.start)
            self._drag.send(pressed)
        shown = self._drag.send(pointer)
        self._gesture.show(shown.document, shown.refs)
        if isinstance(shown, DraggedBox):
            factor = common_factor(ref.address.property for ref in shown.refs)
            self.shown.emit(HandShown(words=words_of(shown.change, factor), beside_px=pointer.view_px))

    def _begun(self, held: CurveGrip | _BoxHeld, start: Document) -> CurveDrag | BoxDrag:
        if isinstance(held, CurveGrip):
            return dragging_curve(start, held, self._choice.kind)
        return dragging_box(start, held.box, held.part, held.pictures)

    def _step_name(self, held: CurveGrip | _BoxHeld) -> str:
        if isinstance(held, _BoxHeld):
            return step_name(held.part)
        return self.tr("Move handle") if isinstance(held.mark, HandleMark) else self.tr("Move keys")

    def _is_on_nothing(self, pointer: GraphPointer, model: GraphModel) -> bool:
        """Whether the hand is where it was pressed, and neither the playhead nor a curve is there."""
        has_moved = self._pressed is not None and _is_far(self._pressed, pointer)
        return not self._scrubs and not has_moved and model.curve_at(pointer.place) is None

    def _let_go(self) -> None:
        was_busy = self.is_busy
        if self._drag is not None:
            self._drag.close()
        self._pressed = self._held = self._gesture = self._drag = None
        self._scrubs = False
        self.shown.emit(HandShown())
        if was_busy:
            self.drag_ended.emit()

    def _choose(self, mark: KeyMark) -> None:
        chosen = self._before
        if self._adds:
            self._bridge.session.select_keys(chosen ^ {mark.ref})
        elif mark.ref not in chosen:
            self._bridge.session.select_keys(frozenset({mark.ref}))

    def _draw_box(self, start: GraphPlace, place: GraphPlace) -> None:
        self.shown.emit(HandShown(box=(start, place)))
        inside = self._model().keys_between(start, place)
        self._bridge.session.select_keys(inside | (self._before if self._adds else frozenset()))

    def _add_key(self, picture: CurvePicture, place: GraphPlace) -> None:
        level = place[1] if self._choice.kind is GraphKind.VALUE else None
        added = with_key(self._bridge.document, picture, max(round(place[0]), 1), level)
        self._bridge.session.edit(self.tr("Add key"), added)


def _box_under(model: GraphModel, place: GraphPlace, modifiers: Qt.KeyboardModifier) -> _BoxHeld | None:
    """Return the frame around keys, where a part of it is under the pointer; its inside only without modifiers."""
    box = model.key_box
    part = None if box is None else box.part_at(place)
    if box is None or part is None or (part.is_inside and modifiers):
        return None
    return _BoxHeld(box, part, model.pictures)


def _is_far(pressed: GraphPointer, pointer: GraphPointer) -> bool:
    """Whether the hand has gone so far that it drags."""
    ways = zip(pointer.view_px, pressed.view_px, strict=True)
    return sum(abs(now - then) for now, then in ways) >= _DRAG_PX
