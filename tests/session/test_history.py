"""Undo and redo as a machine: whatever is done in whatever order, the session is where a list of documents says."""

from pathlib import Path

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from kagezou.animation.track import Interpolation
from kagezou.document import edits, invariants
from kagezou.document.address import Address, addresses
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import FOV, GROUNDING, OPACITY
from kagezou.errors import UsageProblem
from kagezou.geometry.box import Box
from kagezou.io.project.file import dumps, loads
from kagezou.scene.evaluate import evaluate
from kagezou.session.session import Gesture, Session
from tests.documents import FOLDER
from tests.effort import tries

CELS = Cels((Drawing("1", FOLDER / "A/1.png"), Drawing("2", FOLDER / "A/2.png")), (Exposure(1, 0), Exposure(4, 1)))


class History(RuleBasedStateMachine):
    """A session beside the plainest model of one: all documents so far, and which of them is shown."""

    def __init__(self) -> None:
        super().__init__()
        start = edits.add_layer(Document(Canvas(200, 100, length_frames=12)), "A", CELS, Box(10, 10, 60, 90))
        self.session = Session(start)
        self.shown = [start]
        self.at = 0
        self.gesture: Gesture | None = None
        self.tentative: Document | None = None

    # ---- edits

    @rule(value=st.floats(0, 100))
    def set_constant(self, value: float) -> None:
        self._edit(edits.set_constant(self.session.document, Address(FOV), value))

    @rule(frame=st.integers(1, 12), value=st.floats(0, 1), kind=st.sampled_from(Interpolation))
    def set_key(self, frame: int, value: float, kind: Interpolation) -> None:
        layers = self.session.document.layers
        if layers:
            self._edit(edits.set_key(self.session.document, Address(OPACITY, layers[-1].id), frame, value, kind))

    @rule(data=st.data(), frame=st.integers(1, 12))
    def remove_key(self, data: st.DataObject, frame: int) -> None:
        address = data.draw(st.sampled_from(list(addresses(self.session.document))))
        self._edit(edits.remove_key(self.session.document, address, frame))

    @rule(points=st.lists(st.tuples(st.floats(0, 200), st.floats(0, 100)), max_size=3))
    def set_points(self, points: list[tuple[float, float]]) -> None:
        layers = self.session.document.layers
        if layers:
            self._edit(edits.set_constant(self.session.document, Address(GROUNDING, layers[0].id), points))

    @rule(name=st.sampled_from(["A", "B", "影"]))
    def add_layer(self, name: str) -> None:
        self._edit(edits.add_layer(self.session.document, name, CELS, Box(0, 0, 9, 9)))

    @rule(data=st.data())
    def remove_layer(self, data: st.DataObject) -> None:
        layers = self.session.document.layers
        if layers:
            self._edit(edits.remove_layer(self.session.document, data.draw(st.sampled_from(layers)).id))

    @rule(data=st.data(), index=st.integers(0, 3))
    def move_layer(self, data: st.DataObject, index: int) -> None:
        layers = self.session.document.layers
        if layers:
            self._edit(edits.move_layer(self.session.document, data.draw(st.sampled_from(layers)).id, index))

    @rule(length=st.integers(1, 30))
    def set_length(self, length: int) -> None:
        self._edit(edits.set_canvas(self.session.document, Canvas(200, 100, length_frames=length)))

    @rule(path=st.sampled_from([None, FOLDER / "bg.png", Path("/elsewhere.png")]))
    def set_background(self, path: Path | None) -> None:
        self._edit(edits.set_background(self.session.document, path))

    @rule()
    def refused_edit(self) -> None:
        before = self.session.state
        try:
            self._edit(edits.set_constant(self.session.document, Address(FOV), 999))
        except UsageProblem:
            assert self.session.state is before
        else:
            raise AssertionError("999 degrees were taken")

    # ---- gestures

    @precondition(lambda self: self.gesture is None)
    @rule()
    def begin(self) -> None:
        self.gesture = self.session.begin("Drag")
        self.tentative = self.session.document

    @precondition(lambda self: self.gesture is not None)
    @rule(value=st.floats(0, 100))
    def drag(self, value: float) -> None:
        assert self.gesture is not None
        self.tentative = edits.set_constant(self.gesture.start, Address(FOV), value)
        self.gesture.show(self.tentative)

    @precondition(lambda self: self.gesture is not None)
    @rule()
    def release(self) -> None:
        assert self.gesture is not None
        self.gesture.commit()
        self._settle()

    @precondition(lambda self: self.gesture is not None)
    @rule()
    def escape(self) -> None:
        assert self.gesture is not None
        self.gesture.cancel()
        self.gesture = self.tentative = None

    # ---- history and the rest

    @rule()
    def undo(self) -> None:
        self._settle()
        self.at = max(self.at - 1, 0)
        self.session.undo()

    @rule()
    def redo(self) -> None:
        self._settle()
        self.at = min(self.at + 1, len(self.shown) - 1)
        self.session.redo()

    @rule(frame=st.integers(-3, 40))
    def go_to(self, frame: int) -> None:
        self.session.go_to(frame)

    @rule()
    def save_and_load(self) -> None:
        document = self.session.document
        assert loads(dumps(document, FOLDER), FOLDER) == document
        self.session.mark_saved()
        assert self.session.is_saved

    @invariant()
    def the_model_agrees(self) -> None:
        expected = self.shown[self.at] if self.tentative is None else self.tentative
        assert self.session.document is expected
        assert (self.session.undo_name is None) == (self.at == 0)
        assert 1 <= self.session.state.frame <= expected.canvas.length_frames
        invariants.check(expected)
        evaluate(expected, self.session.state.frame)

    def _edit(self, document: Document) -> None:
        """Make an edit; within an open gesture it joins it."""
        self.session.edit("Edit", document)
        if self.gesture is not None:
            self.tentative = document
        elif document is not self.shown[self.at]:
            self._push(document)

    def _settle(self) -> None:
        """Follow the session in making what an open gesture shows into one step."""
        if self.tentative is not None and self.tentative is not self.shown[self.at]:
            self._push(self.tentative)
        self.gesture = self.tentative = None

    def _push(self, document: Document) -> None:
        self.shown = [*self.shown[: self.at + 1], document]
        self.at += 1


TestHistory = History.TestCase
TestHistory.settings = settings(max_examples=tries(20, 60), stateful_step_count=40, deadline=None)
