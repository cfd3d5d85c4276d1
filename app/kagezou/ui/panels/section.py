"""A titled part of the inspector that folds away."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QGridLayout, QMenu, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.system.icons import icon


class Section(QWidget):
    """A header and the rows under it, in four columns: key, name, editor, link."""

    def __init__(self, title: str, menus: PropertyMenus) -> None:
        super().__init__()
        self.title = title
        self._menus = menus
        self._header = QToolButton()
        self._header.setObjectName("section_header")
        self._header.setText(title)
        self._header.setCheckable(True)
        self._header.setChecked(True)
        self._header.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._header.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._header.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._header.toggled.connect(self._fold)
        self._header.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._header.customContextMenuRequested.connect(self._open_menu)
        self._body = QWidget()
        self._grid = QGridLayout(self._body)
        self._grid.setContentsMargins(8, 6, 8, 10)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(2, 1)
        self.rows: list[PropertyRow] = []
        self._edited: list[EditedProperty] = []
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._header)
        column.addWidget(self._body)
        self._fold(opened=True)

    @property
    def is_open(self) -> bool:
        """Whether the rows are shown."""
        return self._header.isChecked()

    def open(self, *, opened: bool) -> None:
        """Show or fold away the rows."""
        self._header.setChecked(opened)

    def add(self, row: PropertyRow) -> None:
        """Put a row under the others."""
        at = len(self.rows)
        self.rows.append(row)
        self._grid.addWidget(row.key, at, 0, Qt.AlignmentFlag.AlignVCenter)
        self._grid.addWidget(row.label, at, 1)
        self._grid.addWidget(row.editor, at, 2)
        self._grid.addWidget(row.link, at, 3, Qt.AlignmentFlag.AlignVCenter)
        self._edited.append(row.edited)
        row.mates = self._edited

    def add_note(self, note: QWidget) -> None:
        """Put something that is no row under all of them."""
        self._grid.addWidget(note, len(self.rows), 0, 1, 4)

    def align(self, label_width: int) -> None:
        """Give the names' column a width, so that the editors of all sections stand in one line."""
        self._grid.setColumnMinimumWidth(1, label_width)

    def _open_menu(self, at: QPoint) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._menus.fill_section(self._edited, menu)
        menu.popup(self._header.mapToGlobal(at))

    def _fold(self, opened: bool) -> None:
        self._body.setVisible(opened)
        self._header.setIcon(icon("chevron-down" if opened else "chevron-right"))
