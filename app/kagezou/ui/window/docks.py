"""The panels of a window at its sides: where each lies at first, and how much room it gets."""

from PySide6.QtCore import QObject, QSize, Qt
from PySide6.QtWidgets import QMainWindow, QVBoxLayout, QWidget

from kagezou.ui.panels.layer_list import LayerList
from kagezou.ui.sets.list import SetList
from kagezou.ui.system.settings import Settings
from kagezou.ui.widgets.dock import Dock
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts

_VERSION = 4
"""Counts up with every new dock: a layout remembered without it is not restored, as it would squeeze the dock in."""

_WINDOW_PX = (1360, 860)
_DOCK_LETTERS = 38
_LAYERS_SHARE = 36
_TIMELINE_SHARE = 27
"""Of 100 parts of the height."""


class LayersAndSet(QWidget):
    """The characters over the set they stand in."""

    def __init__(self, layers: LayerList, pieces: SetList) -> None:
        super().__init__()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        layers.view.setMinimumHeight(56)
        column.addWidget(layers, 1)
        column.addWidget(pieces)
        self.setFocusProxy(layers.view)


class Docks(QObject):
    """Puts the panels into docks of a window, and remembers how they lie.

    Parameters
    ----------
    window
        Where they are put; it gets its first size.
    parts
        The panels, and the menu that lists them.

    Attributes
    ----------
    all
        Layers and set, inspector, styles, timeline, curves.
    layout
        What shows, hides and puts them back.
    """

    def __init__(self, window: QMainWindow, parts: Parts) -> None:
        super().__init__(window)
        self._window = window
        self.all = (
            Dock("layers", self.tr("Layers"), LayersAndSet(parts.panels.layers, parts.sets.pieces)),
            Dock("inspector", self.tr("Inspector"), parts.panels.inspector),
            Dock("styles", self.tr("Styles"), parts.panels.styles),
            Dock("timeline", self.tr("Timeline"), parts.time.timeline),
            Dock("curves", self.tr("Curves"), parts.curves),
        )
        self._add(parts)
        self._arrange()
        # With its panels in it: Qt shares out the room of a window that has a size.
        window.resize(_first_size(window))
        self._share_room()
        self.layout = PanelLayout(window, _VERSION, self._share_room)

    def restore(self, settings: Settings) -> None:
        """Lay the window and its panels as they were when it was closed last."""
        geometry, state = settings.layout("geometry"), settings.layout("state")
        if not geometry.isEmpty():
            self._window.restoreGeometry(geometry)
        if not state.isEmpty():
            self._window.restoreState(state, _VERSION)

    def remember(self, settings: Settings) -> None:
        """Keep how the window and its panels lie."""
        self.layout.bring_back()
        settings.set_layout("geometry", self._window.saveGeometry())
        settings.set_layout("state", self._window.saveState(_VERSION))

    def _add(self, parts: Parts) -> None:
        _, _, styles, timeline, curves = self.all
        areas = Qt.DockWidgetArea
        for dock in self.all:
            below = dock in (timeline, curves)
            self._window.addDockWidget(areas.BottomDockWidgetArea if below else areas.RightDockWidgetArea, dock)
            parts.menus.add_panel(dock.toggleViewAction())
        curves.visibilityChanged.connect(parts.curves.come)
        styles.visibilityChanged.connect(parts.panels.styles.come)

    def _arrange(self) -> None:
        layers, _, styles, timeline, curves = self.all
        # The panels at the right reach down beside the timeline, which needs the width less than they the height.
        self._window.setCorner(Qt.Corner.BottomRightCorner, Qt.DockWidgetArea.RightDockWidgetArea)
        for front, behind in ((layers, styles), (timeline, curves)):
            self._window.tabifyDockWidget(front, behind)
            front.raise_()
        self._window.setDockNestingEnabled(True)

    def _share_room(self) -> None:
        layers, inspector, _, timeline = self.all[:4]
        # In letters, so that it holds at any font size.
        letter = self._window.fontMetrics().horizontalAdvance("0")
        height = self._window.height()
        self._window.resizeDocks([layers, inspector], [_DOCK_LETTERS * letter] * 2, Qt.Orientation.Horizontal)
        self._window.resizeDocks([timeline], [height * _TIMELINE_SHARE // 100], Qt.Orientation.Vertical)
        self._window.resizeDocks([layers, inspector], [_LAYERS_SHARE, 100 - _LAYERS_SHARE], Qt.Orientation.Vertical)


def _first_size(window: QMainWindow) -> QSize:
    """Return the size of a new window: the usual one, as far as its screen has room for it."""
    wanted, screen = QSize(*_WINDOW_PX), window.screen()
    return wanted if screen is None else wanted.boundedTo(screen.availableGeometry().size())
