"""The curve editor: the list of curves, the graph with its tools, and keys, notes and flags to go through."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QLabel,
    QMenu,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from kagezou.animation.ease import EASY, Ease
from kagezou.document.address import track_of
from kagezou.document.ease_edits import set_ease
from kagezou.errors import Problem
from kagezou.io.project.file import load
from kagezou.tools.curves.picture import GraphKind
from kagezou.ui.curves.annotating import Annotating
from kagezou.ui.curves.choice import Choice
from kagezou.ui.curves.columns import Columns
from kagezou.ui.curves.curve_tree import CurveTree
from kagezou.ui.curves.flag_list import FlagList
from kagezou.ui.curves.graph import Graph
from kagezou.ui.curves.key_table import KeyTable
from kagezou.ui.curves.note_list import NoteList
from kagezou.ui.curves.readout import readout
from kagezou.ui.curves.velocity import VelocityDialog
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.shown_units import shown_unit
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.overflow_row import OverflowRow


class CurveEditor(QWidget):
    """Everything about curves, over the session at hand.

    Parameters
    ----------
    bridge
        The session.
    clipboard
        Where copies go.
    """

    refused = Signal(str)

    def __init__(self, bridge: Bridge, clipboard: Clipboard) -> None:
        super().__init__()
        self._bridge = bridge
        self.choice = Choice(bridge)
        self.tree = CurveTree(bridge, self.choice)
        self.graph = Graph(bridge, self.choice)
        self.table = KeyTable(bridge, self.choice, clipboard)
        self.annotating = Annotating(bridge)
        self.notes = NoteList(bridge, self.annotating, lambda: self.table.address)
        self.flags = FlagList(bridge)
        self.key_menu = QMenu(self)
        self.kind_box = self._make_kind_box()
        # It lies over the graph: a line of its own would take a fifth of a low panel.
        self._read = QLabel(self.graph)
        self._read.setObjectName("readout")
        self._read.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._read.move(72, 2)
        self._read.hide()
        self._empty = QLabel(
            self.tr("Nothing is keyed yet: move the playhead and click the diamond before a property."), self.graph
        )
        self._empty.setObjectName("hint")
        self._empty.move(90, 40)
        self._lay_out()
        self._connect()
        self.refresh()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.refresh()

    def refresh(self) -> None:
        """Show everything as it is; behind another panel nothing, and of a drag in the graph alone."""
        if self.isVisible():
            self.graph.refresh()
        if not self._bridge.session.is_in_gesture:
            self._refresh_lists()

    def _refresh_lists(self) -> None:
        if not self.isVisible():
            return
        self.tree.refresh()
        self.table.refresh()
        self.notes.refresh()
        self.flags.refresh()
        self._empty.setVisible(not self.choice.all)

    def take_snapshot(self) -> None:
        """Keep the curves as they are, to compare with."""
        self.choice.set(snapshot=self._bridge.document, shows_snapshot=True)
        self.compare.setChecked(True)

    def swap_snapshot(self) -> None:
        """Put the snapshot in the place of the document, and the document in its place: one step."""
        other, now = self.choice.snapshot, self._bridge.document
        if other is None:
            self.refused.emit(self.tr("There is no snapshot to exchange with yet."))
            return
        self._bridge.session.edit(self.tr("Swap with snapshot"), other)
        if self._bridge.document is other:
            self.choice.set(snapshot=now)

    def compare_with(self, path: Path) -> None:
        """Compare with another saved version of the project."""
        try:
            other = load(path)
        except Problem as problem:
            self.refused.emit(translated(problem))
            return
        self.choice.set(snapshot=other, shows_snapshot=True)
        self.compare.setChecked(True)

    def ask_velocity(self) -> None:
        """Ask for the exact speed and influence of the selected keys."""
        refs = self._bridge.session.state.keys
        if not refs:
            self.refused.emit(self.tr("No keys are selected."))
            return
        ref = min(refs, key=lambda each: each.frame)
        key = track_of(self._bridge.document, ref.address).key_at(ref.frame)
        before = key.ease_in[0] if key is not None and key.ease_in else EASY
        after = key.ease_out[0] if key is not None and key.ease_out else EASY
        dialog = VelocityDialog(before, after, shown_unit(ref.address.property), self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.entered.connect(self._set_velocity)
        dialog.open()

    def show_list(self, *, notes: bool) -> None:
        """Bring the notes or the flags to the front."""
        self._lists.setCurrentWidget(self.notes if notes else self.flags)

    def show_for_review(self, *, on: bool) -> None:
        """Give the graph the room of the list of curves."""
        self.tree.setHidden(on)

    def _set_velocity(self, into: Ease, out: Ease) -> None:
        refs = self._bridge.session.state.keys
        self._bridge.session.edit(self.tr("Key velocity"), set_ease(self._bridge.document, refs, (into,), (out,)))

    def _connect(self) -> None:
        bridge, choice = self._bridge, self.choice
        for signal in (choice.changed, bridge.document_changed, bridge.keys_changed, bridge.selection_changed):
            signal.connect(self.refresh)
        bridge.settled.connect(self._refresh_lists)
        bridge.frame_changed.connect(self.graph.move_playhead)
        bridge.session_replaced.connect(self.graph.fit_all)
        self.graph.controller.read.connect(self._show_readout)
        self.graph.controller.left.connect(self._read.hide)
        self.graph.controller.exact_asked.connect(self.ask_velocity)
        self.graph.menu_asked.connect(self.key_menu.popup)
        self.table.refused.connect(self.refused)
        self.notes.refused.connect(self.refused)

    def _show_readout(self, frame: float, _ordinate: float) -> None:
        whole = min(max(round(frame), 1), self._bridge.document.canvas.length_frames)
        chosen = [each for each in self.graph.pictures if each.chosen]
        picture = next(iter(chosen or self.graph.pictures), None)
        self._read.setText(readout(self._bridge.document, self.choice, picture, whole))
        self._read.adjustSize()
        self._read.show()

    def _lay_out(self) -> None:
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._tools())
        column.addWidget(self.graph, 1)
        tabs = self._lists = QTabWidget()
        tabs.setDocumentMode(True)
        tabs.addTab(self.table, self.tr("Keys"))
        tabs.addTab(self.notes, self.tr("Notes"))
        tabs.addTab(self.flags, self.tr("Flags"))
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(Columns(self.tree, middle, tabs))

    def _tools(self) -> OverflowRow:
        row = OverflowRow()
        row.add_fixed(self.kind_box)
        row.add_tool(self.tr("Fit"), self.tr("Fit the selected keys, else everything (F)"), self.graph.fit_chosen)
        self.normalise = row.add_switch(
            self.tr("Normalise"), self.tr("Stretch every curve to the same height"), self._normalise
        )
        alone = self.tr("Show only curves with selected keys")
        row.add_switch(self.tr("Isolate"), alone, lambda on: self.choice.set(isolates=on))
        keep = self.tr("Keep the curves as they are, to compare with")
        row.add_tool(self.tr("Snapshot"), keep, self.take_snapshot)
        beside = self.tr("Show the snapshot dashed, and the frames that differ")
        self.compare = row.add_switch(self.tr("Compare"), beside, self._compare)
        row.add_tool(self.tr("Swap"), self.tr("Exchange the project with the snapshot"), self.swap_snapshot)
        row.add_tool(self.tr("With File…"), self.tr("Compare with another saved version"), self._ask_file)
        look = self.tr("Look only: nothing can be changed here, nor anywhere in the window")
        self.look_only = row.add_switch(self.tr("Look Only"), look, self._bridge.lock)
        self.look_only.setChecked(self._bridge.is_locked)
        self._bridge.lock_changed.connect(self.look_only.setChecked)
        return row

    def _make_kind_box(self) -> QComboBox:
        box = QComboBox()
        box.addItem(self.tr("Value"), GraphKind.VALUE)
        box.addItem(self.tr("Speed"), GraphKind.SPEED)
        box.setAccessibleName(self.tr("What the graph shows"))
        # A box hands back plain text, whatever was put into it.
        box.currentIndexChanged.connect(lambda index: self._show_kind(GraphKind(box.itemData(index))))
        return box

    def _normalise(self, on: bool) -> None:
        self.choice.set(normalises=on)
        self.graph.fit_all()

    def _compare(self, on: bool) -> None:
        self.choice.set(shows_snapshot=on)
        if on and self.choice.snapshot is None:
            self.refused.emit(
                self.tr("There is nothing to compare with yet: take a snapshot, or choose a saved version.")
            )

    def _show_kind(self, kind: GraphKind) -> None:
        self.choice.set(kind=kind)
        self.graph.fit_all()

    def _ask_file(self) -> None:
        words = self.tr("Compare With")
        chosen, _ = QFileDialog.getOpenFileName(self, words, "", self.tr("Kagezou projects") + " (*.kage *.kage~)")
        if chosen:
            self.compare_with(Path(chosen))
