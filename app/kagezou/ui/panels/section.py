"""A titled part of the inspector that folds away, its rarer lines behind a switch of their own."""

from collections.abc import Callable

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QGridLayout, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.groups import Group, is_rare
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.system.icons import icon

_USUAL_ROWS = 100
"""Rows of the grid for what is used every day; the rarer ones come behind, then the switch. Empty ones take no room."""


class Section(QWidget):
    """A header and the rows under it, in four columns: key, name, editor, link; the rarer rows stand last."""

    folded = Signal(bool)
    """Someone opened it, or folded it away."""
    more_asked = Signal(bool)
    """Someone asked for the rarer rows, or for them to go."""

    def __init__(self, group: Group, menus: PropertyMenus) -> None:
        super().__init__()
        self.group = group
        self._menus = menus
        self._header = QToolButton()
        self._header.setObjectName("section_header")
        self._header.setText(group.title)
        self._header.setCheckable(True)
        self._header.setChecked(True)
        self._header.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._header.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._header.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._header.toggled.connect(self._fold)
        self._header.clicked.connect(self.folded)
        self._header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._header.customContextMenuRequested.connect(self._open_menu)
        self._body = QWidget()
        self._grid = QGridLayout(self._body)
        self._grid.setContentsMargins(8, 6, 8, 10)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(2, 1)
        self.more = QToolButton()
        self.more.setObjectName("more_rows")
        self.more.setCheckable(True)
        self.more.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.more.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.more.toggled.connect(self._show_more_words)
        self.more.clicked.connect(self.more_asked)
        self._grid.addWidget(self.more, 2 * _USUAL_ROWS, 1, 1, 2)
        self.rows: list[PropertyRow] = []
        self._edited: list[EditedProperty] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._header)
        column.addWidget(self._body)
        self._fold(opened=True)
        self._show_more_words(shown=False)

    @property
    def is_open(self) -> bool:
        """Whether the rows are shown."""
        return self._header.isChecked()

    def open(self, *, opened: bool) -> None:
        """Show or fold away the rows."""
        self._header.setChecked(opened)

    def show_more(self, *, shown: bool) -> None:
        """Show the rarer rows too, or only those of them that were changed."""
        self.more.setChecked(shown)

    def add(self, row: PropertyRow) -> None:
        """Put a row under the others of its kind."""
        at = len(self.rows) + (_USUAL_ROWS if is_rare(row.address.property) else 0)
        self.rows.append(row)
        self._grid.addWidget(row.key, at, 0, Qt.AlignmentFlag.AlignVCenter)
        self._grid.addWidget(row.label, at, 1)
        self._grid.addWidget(row.editor, at, 2)
        self._grid.addWidget(row.link, at, 3, Qt.AlignmentFlag.AlignVCenter)
        self._edited.append(row.edited)
        row.mates = self._edited

    def add_note(self, note: QWidget) -> None:
        """Put something that is no row under all of them."""
        self._grid.addWidget(note, 3 * _USUAL_ROWS, 0, 1, 4)

    def show_rows(self, means_something: Callable[[PropertyRow], bool]) -> None:
        """Show the rows that mean something now, of the rarer ones only those that were changed or asked for."""
        has_rare = False
        for row in self.rows:
            matters, rare = means_something(row), is_rare(row.address.property)
            has_rare |= matters and rare
            row.set_visible(visible=matters and (not rare or self.more.isChecked() or row.is_changed))
        self.more.setVisible(has_rare)
        self.setVisible(any(map(means_something, self.rows)))

    def align(self, label_width: int) -> None:
        """Give the names' column a width, so that the editors of all sections stand in one line."""
        self._grid.setColumnMinimumWidth(1, label_width)

    def _open_menu(self, at: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._menus.fill_section(self._edited, menu)
        menu.popup(self._header.mapToGlobal(at))

    def _show_more_words(self, shown: bool) -> None:
        self.more.setText(self.tr("Less") if shown else self.tr("More…"))
        self.more.setIcon(icon("chevron-down" if shown else "chevron-right"))

    def _fold(self, opened: bool) -> None:
        self._body.setVisible(opened)
        self._header.setIcon(icon("chevron-down" if opened else "chevron-right"))
