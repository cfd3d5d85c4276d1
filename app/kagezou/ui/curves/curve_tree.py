"""The list of curves beside the graph: which are shown, in their colours."""

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtGui import QBrush, QColor, QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QTreeWidget, QTreeWidgetItem

from kagezou.document.address import Address
from kagezou.document.key_edits import all_keys
from kagezou.tools.curves.curve_list import Curve
from kagezou.ui.curves.choice import Choice
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

_CURVE = Qt.ItemDataRole.UserRole


class CurveTree(QTreeWidget):
    """A line for every keyed property, with its components below; a tick shows a curve, a click selects its keys."""

    def __init__(self, bridge: Bridge, choice: Choice) -> None:
        super().__init__()
        self._bridge, self._choice = bridge, choice
        self._listed: tuple[Curve, ...] = ()
        self.setHeaderHidden(True)
        self.setRootIsDecorated(True)
        self.setAccessibleName(self.tr("Curves"))
        self.itemChanged.connect(self._show)
        self.itemClicked.connect(self._choose)
        self.refresh()

    def refresh(self) -> None:
        """List the curves there are."""
        if self._choice.all == self._listed:
            return
        self._listed = self._choice.all
        with QSignalBlocker(self):
            self.clear()
            parents: dict[Address, QTreeWidgetItem] = {}
            for curve in self._listed:
                parent = parents.get(curve.address)
                if parent is None:
                    parent = self._property(curve)
                    parents[curve.address] = parent
                if curve.name:
                    self._component(parent, curve)
            self.expandAll()

    def _property(self, curve: Curve) -> QTreeWidgetItem:
        item = QTreeWidgetItem([self._name_of(curve.address)])
        item.setToolTip(0, translated(curve.address.property.help))
        if curve.name:
            item.setFlags(item.flags() | Qt.ItemFlag.ItemIsAutoTristate | Qt.ItemFlag.ItemIsUserCheckable)
        else:
            self._fill(item, curve)
        self.addTopLevelItem(item)
        return item

    def _name_of(self, address: Address) -> str:
        words = translated(address.property.label)
        if address.piece_id is not None:
            return f"{self._bridge.document.piece(address.piece_id).name} · {words}"
        if address.layer_id is None:
            return words
        return f"{self._bridge.document.layer(address.layer_id).name} · {words}"

    def _component(self, parent: QTreeWidgetItem, curve: Curve) -> None:
        item = QTreeWidgetItem([curve.name])
        self._fill(item, curve)
        parent.addChild(item)

    def _fill(self, item: QTreeWidgetItem, curve: Curve) -> None:
        item.setData(0, _CURVE, curve)
        item.setIcon(0, _swatch(curve.color))
        item.setForeground(0, QBrush(QColor(curve.color)))
        item.setFlags(item.flags() | Qt.ItemFlag.ItemIsUserCheckable)
        hidden = self._choice.is_hidden(curve)
        item.setCheckState(0, Qt.CheckState.Unchecked if hidden else Qt.CheckState.Checked)

    def _show(self, item: QTreeWidgetItem) -> None:
        curve = item.data(0, _CURVE)
        if isinstance(curve, Curve):
            self._choice.show((curve,), shown=item.checkState(0) is Qt.CheckState.Checked)

    def _choose(self, item: QTreeWidgetItem) -> None:
        child = item.child(0)
        curve = item.data(0, _CURVE) if child is None else child.data(0, _CURVE)
        if isinstance(curve, Curve):
            self._bridge.session.select_keys(all_keys(self._bridge.document, curve.address))


def _swatch(color: str) -> QIcon:
    picture = QPixmap(12, 12)
    picture.fill(Qt.GlobalColor.transparent)
    painter = QPainter(picture)
    painter.fillRect(1, 4, 10, 4, QColor(color))
    painter.end()
    return QIcon(picture)
