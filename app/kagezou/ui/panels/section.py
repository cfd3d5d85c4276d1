"""A titled part of the inspector that folds away, its rarer lines behind a switch of their own."""

from collections.abc import Callable, Collection, Iterable

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from kagezou.document.address import Address
from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.groups import Group, is_rare
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.system.icons import icon

_USUAL_ROWS = 100
"""Rows of the grid for what is used every day; the rarer ones come behind, then the switch. Empty ones take no room."""


class Section(QWidget):
    """A header and the rows under it, in four columns: key, name, editor, link; the rarer rows stand last.

    A row is made when it is first to be seen, or asked for: most of them nobody opens, and each takes its time.
    """

    folded = Signal(bool)
    """Someone opened it, or folded it away."""
    more_asked = Signal(bool)
    """Someone asked for the rarer rows, or for them to go."""
    made = Signal()
    """A row is there that was not, and shows its value."""

    def __init__(self, group: Group, menus: PropertyMenus) -> None:
        super().__init__()
        self.group = group
        self._menus = menus
        self.header = QToolButton()
        self.header.setObjectName("section_header")
        self.header.setText(group.title)
        self.header.setCheckable(True)
        self.header.setChecked(True)
        self.header.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.header.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.header.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.header.toggled.connect(self._fold)
        self.header.clicked.connect(self.folded)
        self.header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.header.customContextMenuRequested.connect(self._open_menu)
        self._body = QWidget()
        self._grid = _columns_in(self._body)
        self.more = QToolButton()
        self.more.setObjectName("more_rows")
        self.more.setCheckable(True)
        self.more.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.more.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.more.toggled.connect(self._show_more_words)
        self.more.clicked.connect(self.more_asked)
        self._grid.addWidget(self.more, 2 * _USUAL_ROWS, 1, 1, 2)
        self.edited: list[EditedProperty] = []
        """What its rows are about, whether they are made or not."""
        self._rows: dict[Address, PropertyRow] = {}
        self._means_something: Callable[[Address], bool] = lambda _address: True
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.header)
        column.addWidget(self._body)
        self._fold(opened=True)
        self._show_more_words(shown=False)

    @property
    def is_open(self) -> bool:
        """Whether the rows are shown."""
        return self.header.isChecked()

    def open(self, *, opened: bool) -> None:
        """Show or fold away the rows."""
        self.header.setChecked(opened)

    def show_more(self, *, shown: bool) -> None:
        """Show the rarer rows too, or only those of them that were changed."""
        self.more.setChecked(shown)

    @property
    def rows(self) -> list[PropertyRow]:
        """The rows that are made, hidden ones included."""
        return [self._rows[each.address] for each in self.edited if each.address in self._rows]

    def rows_of(self, addresses: Iterable[Address]) -> list[PropertyRow]:
        """Return the rows of properties of this section, made for it where nobody has seen them yet."""
        wanted = list(addresses)
        missing = [
            at for at, each in enumerate(self.edited) if each.address in wanted and each.address not in self._rows
        ]
        for at in missing:
            self._make(at)
        if missing:
            self._put_in_order()
        return [self._rows[each] for each in wanted]

    def reveal(self, wanted: Collection[Address]) -> list[PropertyRow]:
        """Open the section where properties are in it, its rarer rows if one of them is, and return their rows."""
        found = [each.address for each in self.edited if each.address in wanted]
        if found:
            self.open(opened=True)
            self.show_more(shown=self.more.isChecked() or any(is_rare(each.property) for each in found))
        return self.rows_of(found)

    def add(self, edited: EditedProperty) -> None:
        """Take a property up, whose row will stand under the others of its kind."""
        self.edited.append(edited)

    def add_note(self, note: QWidget) -> None:
        """Put something that is no row under all of them."""
        self._grid.addWidget(note, 3 * _USUAL_ROWS, 0, 1, 4)

    def show_rows(self, means_something: Callable[[Address], bool]) -> None:
        """Show the rows that mean something now, of the rarer ones only those that were changed or asked for."""
        self._means_something = means_something
        meant = [each for each in self.edited if means_something(each.address)]
        self.more.setVisible(any(is_rare(each.address.property) for each in meant))
        self.setVisible(bool(meant))
        if self.is_open:
            self.rows_of(each.address for each in meant if self._is_shown(each))
        for row in self.rows:
            row.set_visible(visible=self._is_shown(row.edited))

    def align(self, label_width: int) -> None:
        """Give the names' column a width, so that the editors of all sections stand in one line."""
        self._grid.setColumnMinimumWidth(1, label_width)

    def _is_shown(self, edited: EditedProperty) -> bool:
        if not self._means_something(edited.address):
            return False
        return not is_rare(edited.address.property) or self.more.isChecked() or edited.is_changed

    def _make(self, index: int) -> None:
        edited = self.edited[index]
        row = PropertyRow(edited, self.edited, self._menus)
        at = index + (_USUAL_ROWS if is_rare(edited.address.property) else 0)
        self._grid.addWidget(row.key, at, 0, Qt.AlignmentFlag.AlignVCenter)
        self._grid.addWidget(row.label, at, 1)
        self._grid.addWidget(row.editor, at, 2)
        self._grid.addWidget(row.link, at, 3, Qt.AlignmentFlag.AlignVCenter)
        self._rows[edited.address] = row
        row.refresh()
        row.set_visible(visible=self._is_shown(edited))
        self.made.emit()

    def _put_in_order(self) -> None:
        """Have the Tab key go from row to row as they stand, whenever they were made."""
        before: QWidget = self.header
        for row in sorted(self.rows, key=lambda each: is_rare(each.address.property)):
            for widget in (row.key, *row.editor.findChildren(QWidget), row.link):
                self.setTabOrder(before, widget)
                before = widget
        self.setTabOrder(before, self.more)

    def _open_menu(self, at: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._menus.fill_section(self.edited, menu)
        menu.popup(self.header.mapToGlobal(at))

    def _show_more_words(self, shown: bool) -> None:
        self.more.setText(self.tr("Less") if shown else self.tr("More…"))
        self.more.setIcon(icon("chevron-down" if shown else "chevron-right"))

    def _fold(self, opened: bool) -> None:
        self._body.setVisible(opened)
        self.header.setIcon(icon("chevron-down" if opened else "chevron-right"))


def _columns_in(body: QWidget) -> QGridLayout:
    grid = QGridLayout(body)
    grid.setContentsMargins(8, 6, 8, 10)
    grid.setHorizontalSpacing(6)
    grid.setVerticalSpacing(5)
    grid.setColumnStretch(2, 1)
    return grid
