"""The timeline: names, ruler and lanes side by side, with their scroll bars."""

from PySide6.QtCore import QPoint, QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QGridLayout, QInputDialog, QLabel, QMenu, QScrollBar, QSplitter, QVBoxLayout, QWidget

from kagezou.animation.timecode import Count
from kagezou.document.frame_numbers import number_of
from kagezou.document.model import Marker
from kagezou.document.review import remove_marker, set_marker
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.timeline.drawing_commands import DrawingCommands
from kagezou.ui.timeline.lanes import Lanes
from kagezou.ui.timeline.row_list import RowList
from kagezou.ui.timeline.row_names import RowNames
from kagezou.ui.timeline.ruler import Finished, Kept, Ruler
from kagezou.ui.timeline.time_scale import TimeScale

_NAMES_LETTERS = 36
_READY_EVERY_MS = 700


class Timeline(QWidget):
    """The dope sheet of the session at hand.

    Parameters
    ----------
    bridge
        The session.
    clipboard
        Where copies go.
    kept
        The pictures that are decoded, for the ruler's strip of frames that can be seen at once.
    finished
        The frames that are kept as they are seen, for the same strip.
    """

    count_chosen = Signal(Count)
    drawing_menu_asked = Signal(object)

    def __init__(
        self, bridge: Bridge, clipboard: Clipboard, kept: Kept = frozenset, finished: Finished = frozenset
    ) -> None:
        super().__init__()
        self._bridge = bridge
        self.scale = TimeScale()
        self.rows = RowList(bridge)
        self.rows.row_px = self.fontMetrics().height() + 12
        self.names = RowNames(bridge, self.rows)
        self.lanes = Lanes(bridge, self.scale, self.rows)
        self.drawings = DrawingCommands(bridge, self.lanes.drawings.choice, clipboard)
        self.ruler = Ruler(bridge, self.scale, kept, finished)
        self.key_menu = QMenu(self)
        self._across = QScrollBar(Qt.Orientation.Horizontal)
        self._down = QScrollBar(Qt.Orientation.Vertical)
        self._empty = QLabel(
            self.tr("Nothing is keyed yet: move the playhead and click the diamond before a property.")
        )
        self._lay_out()
        self.ruler.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.ruler.customContextMenuRequested.connect(self._open_ruler_menu)
        self.ruler.marker_asked.connect(self.rename_marker)
        self.lanes.controller.menu_asked.connect(self.key_menu.popup)
        self.lanes.drawings.menu_asked.connect(self.drawing_menu_asked)
        self._across.valueChanged.connect(self.scale.scroll_to)
        self._down.valueChanged.connect(self.rows.scroll_to)
        self.scale.changed.connect(self._show_scroll)
        self.rows.changed.connect(self._show_scroll)
        bridge.document_changed.connect(self._show_document)
        bridge.frame_changed.connect(self._follow)
        bridge.session_replaced.connect(self.scale.fit)
        # What is decoded changes in other threads, and nobody tells.
        self._ready = QTimer(self)
        self._ready.setInterval(_READY_EVERY_MS)
        self._ready.timeout.connect(self.ruler.refresh)
        self._ready.start()
        self._show_document()

    def fit(self) -> None:
        """Show the whole cut."""
        self.scale.fit()

    def zoom(self, factor: float) -> None:
        """Make frames wider or narrower around the playhead."""
        self.scale.zoom(factor, self.scale.middle_of(self._bridge.frame))

    def add_marker(self) -> None:
        """Put a marker on the frame looked at, or ask for the name of the one that is there."""
        frame = self._bridge.frame
        if any(marker.frame == frame for marker in self._bridge.document.markers):
            self.rename_marker(frame)
        else:
            self._bridge.session.edit(self.tr("Set marker"), set_marker(self._bridge.document, Marker(frame)))

    def rename_marker(self, frame: int) -> None:
        """Ask for what the marker on a frame says."""
        marker = next((each for each in self._bridge.document.markers if each.frame == frame), None)
        if marker is None:
            return
        dialog = QInputDialog(self)
        dialog.setWindowTitle(self.tr("Marker"))
        number = number_of(self._bridge.document.canvas, frame)
        dialog.setLabelText(self.tr("What happens on frame %1:").replace("%1", str(number)))
        dialog.setTextValue(marker.comment)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.textValueSelected.connect(lambda words: self._say(frame, words))
        dialog.open()

    def _say(self, frame: int, words: str) -> None:
        document = self._bridge.document
        marker = next((each for each in document.markers if each.frame == frame), None)
        if marker is not None:
            said = Marker(frame, words.strip()[:4000], marker.duration_frames)
            self._bridge.session.edit(self.tr("Name marker"), set_marker(document, said))

    def _lay_out(self) -> None:
        corner = QWidget()
        corner.setFixedHeight(self.ruler.sizeHint().height())
        left, right = QWidget(), QWidget()
        names = QVBoxLayout(left)
        times = QGridLayout(right)
        for layout in (names, times):
            layout.setContentsMargins(0, 0, 0, 0)
            layout.setSpacing(0)
        names.addWidget(corner)
        names.addWidget(self.names, 1)
        names.addSpacing(self._across.sizeHint().height())
        times.addWidget(self.ruler, 0, 0)
        times.addWidget(self.lanes, 1, 0)
        times.addWidget(self._across, 2, 0)
        times.addWidget(self._down, 1, 1)
        times.setRowStretch(1, 1)
        self._empty.setParent(self.lanes)
        self._empty.setObjectName("hint")
        self._empty.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        splitter = QSplitter(Qt.Orientation.Horizontal)
        splitter.setChildrenCollapsible(False)
        splitter.addWidget(left)
        splitter.addWidget(right)
        splitter.setStretchFactor(1, 1)
        letter = self.fontMetrics().horizontalAdvance("0")
        left.setMinimumWidth(16 * letter)
        splitter.setSizes([_NAMES_LETTERS * letter, 10 * _NAMES_LETTERS * letter])
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(splitter)
        self.setMinimumHeight(5 * self.rows.row_px)

    def _show_document(self) -> None:
        self.scale.set_length(self._bridge.document.canvas.length_frames)
        keyed = any(row.addresses for row in self.rows.rows)
        self._empty.setVisible(not keyed)
        if not keyed:
            self._empty.adjustSize()
            self._empty.move(16, (len(self.rows.rows) + 1) * self.rows.row_px)

    def _show_scroll(self) -> None:
        for bar, value, furthest, page in (
            (self._across, self.scale.scroll_px, self.scale.furthest_px, self.scale.width_px),
            (self._down, self.rows.scroll_px, self.rows.furthest_px, self.lanes.height()),
        ):
            with QSignalBlocker(bar):
                bar.setRange(0, round(furthest))
                bar.setPageStep(page)
                bar.setSingleStep(self.rows.row_px)
                bar.setValue(round(value))

    def _follow(self, frame: int) -> None:
        if not (self.lanes.controller.is_busy or self.lanes.drawings.is_busy):
            self.scale.reveal(frame)

    def _open_ruler_menu(self, place: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        marker = self.ruler.marker_at(place.toPointF())
        if marker is not None:
            menu.addAction(self.tr("Rename Marker…"), lambda: self.rename_marker(marker.frame))
            menu.addAction(self.tr("Remove Marker"), lambda: self._remove_marker(marker.frame))
            menu.addSeparator()
        words = {
            Count.FRAMES: self.tr("Frames (84)"),
            Count.SECONDS: self.tr("Seconds + frames (3+12)"),
            Count.SHEET_6: self.tr("Sheet pages of 6 seconds"),
            Count.SHEET_3: self.tr("Sheet pages of 3 seconds"),
            Count.TIMECODE: self.tr("Timecode (00:03:12)"),
        }
        group = QActionGroup(menu)
        for count, text in words.items():
            action = QAction(text, group)
            action.setCheckable(True)
            action.setChecked(count is self.ruler.count)
            action.triggered.connect(lambda _checked, each=count: self._choose_count(each))
        menu.addActions(group.actions())
        menu.popup(self.ruler.mapToGlobal(place))

    def _choose_count(self, count: Count) -> None:
        self.ruler.show_count(count)
        self.count_chosen.emit(count)

    def _remove_marker(self, frame: int) -> None:
        self._bridge.session.edit(self.tr("Remove marker"), remove_marker(self._bridge.document, frame))
