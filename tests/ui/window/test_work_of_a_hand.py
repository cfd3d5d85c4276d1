"""Work of hands that are faster than the window: counted, never timed."""

from dataclasses import replace
from functools import partial

from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QPaintEvent
from PySide6.QtWidgets import QApplication, QTableWidget, QWidget
from pytestqt.qtbot import QtBot

from kagezou.animation.track import Interpolation
from kagezou.document.address import Address
from kagezou.document.edits import rename_layer, set_canvas, set_constant, set_key
from kagezou.document.key_edits import KeyRef
from kagezou.document.properties import GROUND_ROLL, OF_LAYER
from kagezou.ui.curves.graph import Graph
from kagezou.ui.widgets.once_a_paint import OnceAPaint
from kagezou.ui.window.main_window import MainWindow


class ByHand(QMouseEvent):
    """A move as it comes from the window system."""

    def spontaneous(self) -> bool:
        return True


def moved(x: float, *, by_hand: bool = True) -> QMouseEvent:
    place, button = QPointF(x, 5), Qt.MouseButton.NoButton
    kind = ByHand if by_hand else QMouseEvent
    return kind(QEvent.Type.MouseMove, place, place, button, button, Qt.KeyboardModifier.NoModifier)


def _first_value(table: QTableWidget) -> str:
    item = table.item(0, 2)
    assert item is not None
    return item.text()


def test_of_moves_that_come_together_the_last_is_done_and_then_painted(qtbot: QtBot) -> None:
    widget, done = QWidget(), list[int]()
    qtbot.addWidget(widget)
    pace = OnceAPaint(widget)
    for x in (1, 2, 3):
        pace.take(moved(x), partial(done.append, x))
    assert done == []
    qtbot.waitUntil(lambda: done == [3])
    pace.take(moved(4), partial(done.append, 4))
    pace.finish()
    assert done == [3, 4], "whoever lets go must not lose the last move"
    pace.finish()
    QApplication.processEvents()
    assert done == [3, 4]


def test_what_a_program_sends_is_done_at_once_and_in_order(qtbot: QtBot) -> None:
    widget, done = QWidget(), list[int]()
    qtbot.addWidget(widget)
    pace = OnceAPaint(widget)
    pace.take(moved(1), partial(done.append, 1))
    pace.take(moved(2, by_hand=False), partial(done.append, 2))
    assert done == [1, 2]


def test_the_playhead_moves_without_painting_lanes_or_ruler_anew(walking: MainWindow) -> None:
    timeline, bridge = walking.parts.time.timeline, walking.parts.bridge
    still = [timeline.lanes.still, timeline.ruler.still]
    for widget in (timeline.lanes, timeline.ruler):
        widget.grab()
    before = [each.times_painted for each in still]
    first = timeline.lanes.grab().toImage()
    for frame in (2, 3, 4):
        bridge.session.go_to(frame)
        timeline.lanes.grab()
        timeline.ruler.grab()
    assert timeline.lanes.grab().toImage() != first, "the playhead is seen where it is"
    assert [each.times_painted for each in still] == before
    bridge.session.go_to(1)
    assert timeline.lanes.grab().toImage() == first


def test_keys_and_choices_paint_the_lanes_anew(walking: MainWindow) -> None:
    lanes, bridge = walking.parts.time.timeline.lanes, walking.parts.bridge
    address = Address(OF_LAYER["shadow.opacity"], bridge.document.layers[0].id)
    lanes.grab()
    for frame in (1, 3):
        before = lanes.still.times_painted
        bridge.session.edit("Key", set_key(bridge.document, address, frame, 0.5))
        lanes.grab()
        assert lanes.still.times_painted == before + 1


def test_a_drag_in_the_graph_draws_the_curve_that_changed_and_reads_no_list(walking: MainWindow) -> None:
    bridge = walking.parts.bridge
    names = ("shadow.opacity", "shadow.simplify")
    document = bridge.document
    addresses = [Address(OF_LAYER[name], document.layers[0].id) for name in names]
    for address in addresses:
        for frame, value in ((1, 0.2), (4, 0.6)):
            document = set_key(document, address, frame, value)
    bridge.session.edit("Keys", document)
    walking.parts.actions["curves"].trigger()
    editor = walking.parts.curves.made()
    QApplication.processEvents()
    drawn, rows = editor.graph.drawn.curves_drawn, editor.table.rowCount()
    first = _first_value(editor.table)
    listed = editor.table.address
    assert listed is not None
    gesture = bridge.session.begin("Drag")
    for value in (0.3, 0.4, 0.5):
        gesture.show(set_key(bridge.document, listed, 1, value))
    assert editor.graph.drawn.curves_drawn == drawn + 3, "one curve a move, not all of them"
    assert _first_value(editor.table) == first
    gesture.commit()
    assert editor.table.rowCount() == rows
    assert _first_value(editor.table) != first


def _graph_of_twelve_keys(window: MainWindow) -> tuple[Graph, Address]:
    """Two curves of a key on every frame, settled and painted; and what the first of them is of."""
    bridge, document = window.parts.bridge, window.parts.bridge.document
    addresses = [Address(OF_LAYER[name], document.layers[0].id) for name in ("shadow.opacity", "shadow.simplify")]
    document = set_canvas(document, replace(document.canvas, length_frames=12))
    for number, address in enumerate(addresses):
        for frame in range(1, 13):
            document = set_key(document, address, frame, 0.1 * (number + frame % 7), Interpolation.BEZIER)
    bridge.session.edit("Keys", document)
    window.parts.actions["curves"].trigger()
    graph = window.parts.curves.made().graph
    graph.fit_all()
    bridge.session.select_keys(frozenset({KeyRef(addresses[0], 6)}))
    QApplication.processEvents()
    graph.grab()
    return graph, addresses[0]


def test_a_dragged_key_paints_its_curve_anew_between_its_neighbours_and_no_other(walking: MainWindow) -> None:
    graph, address = _graph_of_twelve_keys(walking)
    gesture = walking.parts.bridge.session.begin("Drag")
    gesture.show(set_key(walking.parts.bridge.document, address, 6, 0.3))
    graph.grab()
    resting, moving = graph.drawn.resting, graph.drawn.moving
    painted, moved = [each.times_painted for each in resting], [each.times_painted for each in moving]
    for times, value in enumerate((0.4, 0.5, 0.55), start=1):
        gesture.show(set_key(walking.parts.bridge.document, address, 6, value))
        graph.grab()
        assert [each.times_painted for each in resting] == painted
        assert [each.times_painted for each in moving] == [before + times for before in moved]
        # Qt takes one unit of the graph more to each side.
        room = 1 + 12 * graph.view.viewPixelSize()[0]
        for first, last in (each.painted for each in moving):
            assert 5 - room < first <= 5 < 7 <= last < 7 + room
    seen = graph.grab().toImage()
    for sheet in (*resting, *moving):
        sheet.update()
    assert graph.grab().toImage() == seen, "of parts painted anew the same comes as of the whole"
    gesture.cancel()


def test_a_dragged_key_leaves_marks_on_the_picture_rows_and_other_layers_alone(walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    twin = replace(bridge.document.layers[0], id="twin", name="Twin")
    bridge.session.edit("Twin", replace(bridge.document, layers=(*bridge.document.layers, twin)))
    address = Address(OF_LAYER["shadow.opacity"], bridge.document.layers[0].id)
    bridge.session.edit("Key", set_key(bridge.document, address, 1, 0.9))
    painter, overlay, rows = viewport.frame_painter, viewport.overlay, walking.parts.panels.layers.model
    assert painter is not None
    for _ in range(3):
        viewport.grab()
    told: list[object] = []
    rows.dataChanged.connect(lambda *_: told.append(rows))
    made, marks, pictures = painter.layers.times_made, overlay.kept.times_painted, painter.pictures_drawn
    gesture = bridge.session.begin("Drag")
    for times, value in enumerate((0.3, 0.4, 0.5), start=1):
        gesture.show(set_key(bridge.document, address, 1, value))
        viewport.grab()
        assert painter.pictures_drawn == pictures + times, "the picture shows the key that moves"
        assert painter.layers.times_made == made + times, "one layer of two"
    assert overlay.kept.times_painted == marks
    assert told == []
    gesture.commit()
    bridge.session.edit("Rename", rename_layer(bridge.document, "twin", "Other"))
    assert told


def test_marks_that_move_are_painted_as_they_are(walking: MainWindow) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    overlay = viewport.overlay
    for _ in range(3):
        still = overlay.grab().toImage()
    painted = overlay.kept.times_painted
    assert overlay.grab().toImage() == still
    assert overlay.kept.times_painted == painted
    ground = bridge.document
    bridge.session.edit("Ground", set_constant(ground, Address(GROUND_ROLL), 12.0))
    assert overlay.grab().toImage() != still
    bridge.session.edit("Ground", ground)
    for _ in range(2):
        back = overlay.grab().toImage()
    assert back == still
    assert overlay.kept.times_painted == painted + 3


def test_a_move_in_the_graph_paints_it_once(walking: MainWindow, qtbot: QtBot) -> None:
    graph, address = _graph_of_twelve_keys(walking)
    mark = next(each for picture in graph.pictures for each in picture.keys if each.ref == KeyRef(address, 6))
    scene = graph.view.mapViewToScene(QPointF(mark.frame, mark.ordinate))
    place = QPointF(graph.mapFromScene(scene))
    button, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    viewport, keys = graph.viewport(), Qt.KeyboardModifier.NoModifier
    down = QMouseEvent(QEvent.Type.MouseButtonPress, place, viewport.mapToGlobal(place), button, button, keys)
    QApplication.sendEvent(viewport, down)
    QApplication.processEvents()
    paintings = Paintings(viewport)
    for count, down_px in enumerate((8, 12, 16), start=1):
        at = place + QPointF(0, down_px)
        QApplication.sendEvent(
            viewport, ByHand(QEvent.Type.MouseMove, at, viewport.mapToGlobal(at), none, button, keys)
        )
        qtbot.waitUntil(partial(paintings.are, count))
        QApplication.processEvents()
        assert paintings.count == count
    graph.controller.cancel()


class Paintings(QObject):
    """Counts how often all of a widget is painted; words over it appear and change their width beside that."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self.count = 0
        widget.installEventFilter(self)

    def are(self, count: int) -> bool:
        return self.count >= count

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        self.count += isinstance(event, QPaintEvent) and event.region().boundingRect() == self._widget.rect()
        return False


def test_while_a_hand_scrubs_the_picture_comes_after_the_playhead(walking: MainWindow, qtbot: QtBot) -> None:
    viewport, bridge = walking.parts.viewport, walking.parts.bridge
    viewport.grab()
    due: list[int] = []
    viewport.following.due.connect(lambda: due.append(bridge.frame))
    bridge.let_pass(on=True, by_hand=True)
    for frame in (2, 3, 4, 5):
        bridge.session.go_to(frame)
    assert due == [], "nobody waits for it"
    qtbot.waitUntil(lambda: due == [5])
    bridge.let_pass(on=False)
    bridge.session.go_to(2)
    assert due == [5, 2]
