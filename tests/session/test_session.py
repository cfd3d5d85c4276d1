"""The session: one step a gesture, undo that shows what it undid, one callback."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.key_edits import KeyRef, Refs, present_keys
from kagezou.document.marking import set_marks
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import FOV, OPACITY
from kagezou.geometry.box import Box
from kagezou.session import state
from kagezou.session.history import MAX_STEPS
from kagezou.session.session import Session
from kagezou.session.state import State

CELS = Cels((Drawing("1", Path("/c/1.png")),), (Exposure(1, 0),))


def fov(document: Document, value: float) -> Document:
    return edits.set_constant(document, Address(FOV), value)


@pytest.fixture
def document() -> Document:
    two = edits.add_layer(Document(Canvas(100, 100, length_frames=20)), "A", CELS, Box(0, 0, 9, 9))
    return edits.add_layer(two, "B", CELS, Box(0, 0, 9, 9))


@pytest.fixture
def session(document: Document) -> Session:
    return Session(document)


def watched(session: Session) -> list[tuple[State, State]]:
    seen: list[tuple[State, State]] = []
    session.listen(lambda before, after: seen.append((before, after)))
    return seen


def test_a_session_begins_saved_on_the_top_layer(session: Session, document: Document) -> None:
    assert session.state == State(document, 1, "layer-2")
    assert session.is_saved
    assert (session.undo_name, session.redo_name) == (None, None)
    assert Session(Document(Canvas(1, 1))).state.layer_id is None


def test_an_edit_is_one_step(session: Session, document: Document) -> None:
    changed = fov(document, 30.0)
    session.edit("Set view", changed)
    assert session.document is changed
    names = [(session.undo_name, session.redo_name)]
    saved = [session.is_saved]
    session.undo()
    assert session.document is document
    assert [*saved, session.is_saved] == [False, True]
    names.append((session.undo_name, session.redo_name))
    assert names == [("Set view", None), (None, "Set view")]
    session.redo()
    assert session.document is changed
    session.redo()
    assert session.document is changed


def test_the_same_document_is_no_step(session: Session, document: Document) -> None:
    seen = watched(session)
    session.edit("Nothing", document)
    assert session.undo_name is None
    assert seen == []


def test_a_gesture_is_one_step_however_long(session: Session, document: Document) -> None:
    with session.gesture("Drag") as gesture:
        for value in (1.0, 2.0, 3.0):
            gesture.show(fov(gesture.start, value))
            assert session.document.tracks["camera.fov"].constant == value
    session.undo()
    assert session.document is document


def test_a_gesture_that_comes_back_is_no_step(session: Session, document: Document) -> None:
    with session.gesture("Drag") as gesture:
        gesture.show(fov(document, 1.0))
        gesture.show(document)
    assert session.undo_name is None


def test_a_cancelled_gesture_restores(session: Session, document: Document) -> None:
    gesture = session.begin("Drag")
    gesture.show(fov(document, 1.0))
    gesture.cancel()
    gesture.show(fov(document, 2.0))
    gesture.commit()
    assert session.document is document
    assert session.undo_name is None


def test_an_exception_within_a_gesture_restores(session: Session, document: Document) -> None:
    def fail() -> None:
        with session.gesture("Drag") as gesture:
            gesture.show(fov(document, 1.0))
            raise RuntimeError("pen lost")

    with pytest.raises(RuntimeError, match="pen lost"):
        fail()
    assert session.document is document


def test_an_edit_within_a_gesture_joins_it(session: Session, document: Document) -> None:
    with session.gesture("Outer"):
        session.edit("Inner", fov(session.document, 1.0))
        session.edit("Inner", fov(session.document, 2.0))
    assert session.undo_name == "Outer"
    session.undo()
    assert session.document is document


def test_beginning_or_undoing_ends_an_open_gesture(session: Session, document: Document) -> None:
    session.begin("First").show(fov(document, 1.0))
    session.begin("Second").show(fov(document, 2.0))
    assert session.undo_name == "First"
    session.undo()
    assert session.document.tracks["camera.fov"].constant == 1.0
    assert session.redo_name == "Second"
    session.begin("Third").show(fov(document, 3.0))
    session.redo()
    assert session.document.tracks["camera.fov"].constant == 3.0


def test_a_new_step_forgets_what_was_undone(session: Session, document: Document) -> None:
    session.edit("One", fov(document, 1.0))
    session.undo()
    session.edit("Two", fov(document, 2.0))
    assert session.redo_name is None


def test_undo_shows_frame_and_selection_it_was_made_with(session: Session, document: Document) -> None:
    session.go_to(7)
    session.select("layer-1", (Address(OPACITY, "layer-1"),))
    session.edit("Set view", fov(document, 1.0))
    session.go_to(15)
    session.select(None)
    session.undo()
    assert session.state == State(document, 7, "layer-1", (Address(OPACITY, "layer-1"),))


def test_history_has_an_end(session: Session) -> None:
    for value in range(MAX_STEPS + 10):
        session.edit("Step", fov(session.document, value / 100))
    count = 0
    while session.undo_name is not None:
        session.undo()
        count += 1
    assert count == MAX_STEPS


def test_frames_stay_within_the_cut(session: Session, document: Document) -> None:
    session.go_to(99)
    assert session.state.frame == 20
    session.go_to(-4)
    assert session.state.frame == 1
    session.go_to(20)
    session.edit("Shorten", edits.set_canvas(document, Canvas(100, 100, length_frames=5)))
    assert session.state.frame == 5


def test_selection_stays_within_the_layers(session: Session, document: Document) -> None:
    session.select("layer-2", (Address(OPACITY, "layer-2"), Address(FOV)))
    session.edit("Remove", edits.remove_layer(document, "layer-2"))
    assert (session.state.layer_id, session.state.selection) == ("layer-1", (Address(FOV),))
    session.edit("Remove", edits.remove_layer(session.document, "layer-1"))
    assert session.state.layer_id is None


def test_every_change_is_told_once(session: Session, document: Document) -> None:
    seen = watched(session)
    session.go_to(5)
    session.go_to(5)
    session.select("layer-1")
    assert len(seen) == 2
    before, after = seen[0]
    assert (before.frame, after.frame) == (1, 5)
    session.edit("Set view", fov(document, 1.0))
    assert seen[2][0].document is document
    assert seen[2][1].document is session.document


def test_saving_is_told(session: Session, document: Document) -> None:
    session.edit("Set view", fov(document, 1.0))
    seen = watched(session)
    session.mark_saved()
    assert session.is_saved
    assert len(seen) == 1
    session.undo()
    assert not session.is_saved


def test_what_was_found_out_is_as_true_of_every_earlier_state(session: Session, document: Document) -> None:
    session.edit("Field of view", fov(document, 20.0))
    session.edit("Field of view", fov(document, 30.0))
    session.undo()

    def renamed(each: Document) -> Document:
        return edits.rename_layer(each, "layer-1", "found")

    session.mark_saved()
    steps = session.history.made
    session.amend(renamed)
    assert session.document.layers[0].name == "found"
    assert not session.is_saved
    assert (session.history.made, session.undo_name) == (steps, "Field of view")
    session.redo()
    assert session.document == renamed(fov(document, 30.0))
    session.undo()
    session.undo()
    assert session.document == renamed(document)
    assert session.undo_name is None


def test_a_locked_session_refuses_every_edit_and_says_so(session: Session) -> None:
    session.edit("First", fov(session.document, 20.0))
    before = session.state
    refused: list[bool] = []
    session.told_of_refusals.append(lambda: refused.append(session.is_locked))
    session.lock(locked=True)
    session.edit("Second", fov(session.document, 25.0))
    gesture = session.begin("Drag")
    gesture.show(fov(session.document, 30.0))
    gesture.commit()
    session.undo()
    session.redo()
    assert session.state == before
    # There is nothing to bring back, so that nothing is refused either.
    assert refused == [True] * 3
    session.go_to(2)
    assert session.state.frame == 2
    session.lock(locked=False)
    session.undo()
    assert session.document is not before.document


def test_locking_ends_what_is_under_way(session: Session) -> None:
    gesture = session.begin("Drag")
    dragged = fov(session.document, 31.0)
    gesture.show(dragged)
    session.lock(locked=True)
    assert session.document is dragged
    gesture.show(fov(session.document, 32.0))
    assert (session.document, session.is_in_gesture) == (dragged, False)


def test_selected_keys_are_looked_for_only_where_they_could_have_gone(
    session: Session, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[int] = []

    def noting(document: Document, refs: Refs) -> Refs:
        looked.append(len(refs))
        return present_keys(document, refs)

    monkeypatch.setattr(state, "present_keys", noting)
    address = Address(FOV)
    session.edit("Key", edits.set_key(edits.set_key(document, address, 1, 20.0), address, 9, 40.0))
    session.select_keys(frozenset({KeyRef(address, 1), KeyRef(address, 9)}))
    looked.clear()
    session.go_to(5)
    session.select("layer-1")
    assert looked == []
    session.edit("Unkey", edits.remove_key(session.document, address, 9))
    assert looked
    assert session.state.keys == {KeyRef(address, 1)}


def test_locked_layers_are_left_alone_and_whoever_tries_is_told(session: Session, document: Document) -> None:
    session.edit("Lock", set_marks(document, ("layer-1",), lambda marks: replace(marks, is_locked=True)))
    told: list[tuple[str, ...]] = []
    session.told_of_locked.append(told.append)
    before = session.document
    session.edit("Change", edits.set_constant(before, Address(OPACITY, "layer-1"), 0.1))
    assert session.document is before
    assert session.undo_name == "Lock"
    assert told == [("A",)]
    session.edit("Change", edits.set_constant(before, Address(OPACITY, "layer-2"), 0.1))
    assert session.undo_name == "Change"
    with session.gesture("Drag") as gesture:
        gesture.show(fov(session.document, 20))
        gesture.show(edits.remove_layer(session.document, "layer-1"))
    assert [layer.name for layer in session.document.layers] == ["A", "B"]
    session.undo()
    session.undo()
    session.undo()
    assert session.document is document, "what was done before is taken back all the same"
