"""Finding a command by typing a part of its name, in English or Japanese, and running it."""

from collections.abc import Iterator
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QModelIndex, QObject, QPersistentModelIndex, QRect, QSize, Qt, QTimer
from PySide6.QtGui import QAction, QFontMetrics, QKeyEvent, QPainter, QStandardItem, QStandardItemModel
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QLabel,
    QLineEdit,
    QListView,
    QMainWindow,
    QMenu,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from kagezou.ui.commands.actions import Actions, shown_keys
from kagezou.ui.commands.fuzzy import score
from kagezou.ui.system.language import in_all_languages
from kagezou.ui.system.menu_words import plain
from kagezou.ui.system.theme import BRIGHT, CHOSEN, DIM, OFF, TEXT

_LETTERS_WIDE = 74
_ROWS_SHOWN = 11
_ROW_MARGIN_PX = 6
_MAX_RECENT = 6

_WORDS, _PLACE, _KEYS, _ENTRY = (Qt.ItemDataRole.UserRole + each for each in range(4))


@dataclass(frozen=True, slots=True)
class Entry:
    """Something that can be found and run.

    Parameters
    ----------
    action
        What runs.
    words
        What people read, and what it is called in every language: each is searched.
    place
        The heading or menu it stands under.
    keys
        Its keys, written for people.
    """

    action: QAction
    words: tuple[str, ...]
    place: str
    keys: str


class CommandSearch(QFrame):
    """A field over a list at the top of the window; gone when something was run or the keyboard goes elsewhere.

    Parameters
    ----------
    window
        The window it lies over; what its menus hold beside the commands is found too.
    actions
        The commands.
    """

    def __init__(self, window: QMainWindow, actions: Actions) -> None:
        super().__init__(window)
        self._window = window
        self._actions = actions
        self._entries: tuple[Entry, ...] = ()
        self._recent: list[str] = []
        self._focus_before: QWidget | None = None
        self.setObjectName("command_search")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.field = QLineEdit()
        self.field.setPlaceholderText(self.tr("Type a part of a command's name"))
        self.field.setAccessibleName(self.tr("Find a command"))
        self.field.setClearButtonEnabled(False)
        self.field.textChanged.connect(self._show_found)
        self.field.installEventFilter(self)
        self.model = QStandardItemModel(self)
        self.view = self._made_view()
        self._nothing = QLabel(self.tr("No command of this name"))
        self._nothing.setObjectName("welcome_hint")
        self._nothing.setAlignment(Qt.AlignmentFlag.AlignCenter)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(6)
        for widget in (self.field, self.view, self._nothing):
            column.addWidget(widget)
        self.hide()

    def open(self) -> None:
        """Show it, empty, with the keyboard."""
        if not self.isVisible():
            self._focus_before = QApplication.focusWidget()
        self._entries = (*_commands(self._actions), *_choices(self._window, self._actions))
        self.field.clear()
        self._show_found("")
        metrics = self.fontMetrics()
        wide = min(_LETTERS_WIDE * metrics.averageCharWidth(), self._window.width() - 40)
        self.setFixedWidth(wide)
        self.adjustSize()
        self.move((self._window.width() - wide) // 2, self._window.menuBar().height() + 3 * metrics.height())
        self.show()
        self.raise_()
        self.field.setFocus(Qt.FocusReason.PopupFocusReason)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.FocusOut and not self.field.hasFocus():
            self.hide()
        elif isinstance(event, QKeyEvent) and event.type() is QEvent.Type.KeyPress:
            return self._press(event)
        return super().eventFilter(watched, event)

    def run_current(self) -> None:
        """Run what is chosen, as if it had been chosen in a menu."""
        index = self.view.currentIndex()
        entry = index.data(_ENTRY) if index.isValid() else None
        if not isinstance(entry, Entry) or not entry.action.isEnabled():
            return
        self._recent = [entry.words[0], *(each for each in self._recent if each != entry.words[0])][:_MAX_RECENT]
        self._leave()
        # After the keyboard is back where it was: what a command does may depend on that.
        QTimer.singleShot(0, entry.action, entry.action.trigger)

    def _made_view(self) -> QListView:
        view = QListView()
        view.setModel(self.model)
        view.setItemDelegate(_Row(view))
        view.setUniformItemSizes(True)
        view.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        view.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        view.setMouseTracking(True)
        view.entered.connect(view.setCurrentIndex)
        view.clicked.connect(lambda _: self.run_current())
        return view

    def _press(self, event: QKeyEvent) -> bool:
        rows = {
            Qt.Key.Key_Up: -1,
            Qt.Key.Key_Down: 1,
            Qt.Key.Key_PageUp: -_ROWS_SHOWN,
            Qt.Key.Key_PageDown: _ROWS_SHOWN,
        }
        if event.key() == Qt.Key.Key_Escape:
            self._leave()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.run_current()
        elif event.key() in rows:
            row = self.view.currentIndex().row() + rows[Qt.Key(event.key())]
            self.view.setCurrentIndex(self.model.index(min(max(row, 0), self.model.rowCount() - 1), 0))
        else:
            return event.key() in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab)
        return True

    def _leave(self) -> None:
        self.hide()
        if self._focus_before is not None and self._focus_before.isVisible():
            self._focus_before.setFocus(Qt.FocusReason.PopupFocusReason)

    def _show_found(self, typed: str) -> None:
        self.model.clear()
        for entry in self._found(typed):
            item = QStandardItem(entry.words[0])
            item.setEditable(False)
            for role, value in ((_WORDS, entry.words[0]), (_PLACE, entry.place), (_KEYS, entry.keys), (_ENTRY, entry)):
                item.setData(value, role)
            self.model.appendRow(item)
        found = self.model.rowCount() > 0
        if found:
            self.view.setCurrentIndex(self.model.index(0, 0))
        row = self.view.fontMetrics().height() + 2 * _ROW_MARGIN_PX
        self.view.setFixedHeight(min(self.model.rowCount(), _ROWS_SHOWN) * row + 2)
        self._nothing.setFixedHeight(2 * row)
        self.view.setVisible(found)
        self._nothing.setVisible(not found)
        self.adjustSize()

    def _found(self, typed: str) -> list[Entry]:
        """Return what fits, best first; among equals what was run lately, then what can be run now."""
        fitting = []
        for order, entry in enumerate(self._entries):
            if typed.strip():
                scores = [each for words in entry.words if (each := score(typed, words)) is not None]
                fit = max(scores, default=None)
            else:
                fit = 0
            if fit is not None:
                lately = self._recent.index(entry.words[0]) if entry.words[0] in self._recent else _MAX_RECENT
                fitting.append(((-fit, lately, not entry.action.isEnabled(), order), entry))
        return [entry for _, entry in sorted(fitting, key=lambda each: each[0])]


class _Row(QStyledItemDelegate):
    """Name at the left, keys at the right, the heading between, dim."""

    def sizeHint(self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex) -> QSize:
        return QSize(0, QFontMetrics(option.font).height() + 2 * _ROW_MARGIN_PX)

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        entry = index.data(_ENTRY)
        view = option.widget
        chosen = isinstance(view, QListView) and index == view.currentIndex()
        painter.save()
        painter.setFont(option.font)
        room: QRect = option.rect.adjusted(8, 0, -10, 0)
        if chosen:
            painter.fillRect(option.rect, CHOSEN)
        metrics, middle = QFontMetrics(option.font), Qt.AlignmentFlag.AlignVCenter
        can_run = entry.action.isEnabled()
        painter.setPen((BRIGHT if chosen else TEXT) if can_run else OFF)
        painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, index.data(_WORDS))
        painter.setPen(TEXT if can_run else OFF)
        painter.drawText(room, middle | Qt.AlignmentFlag.AlignRight, index.data(_KEYS))
        painter.setPen(DIM if can_run and not chosen else TEXT if can_run else OFF)
        place = room.adjusted(metrics.horizontalAdvance(index.data(_WORDS)) + 12, 0, 0, 0)
        painter.drawText(place, middle | Qt.AlignmentFlag.AlignLeft, index.data(_PLACE))
        painter.restore()


def _commands(actions: Actions) -> Iterator[Entry]:
    """Yield the commands of the table that someone answers."""
    for group in actions.groups:
        for command in group.commands:
            if actions.is_answered(command.name):
                names = in_all_languages("Commands", command.source)
                words = (plain(actions[command.name].text()), *map(plain, names))
                yield Entry(actions[command.name], words, group.title, shown_keys(actions.keys(command.name)[:1]))


def _choices(window: QMainWindow, actions: Actions) -> Iterator[Entry]:
    """Yield what else the menus offer: panels, backdrops, languages, recent projects."""
    known = {actions[command.name] for command in actions.commands}
    menus = [(menu, "") for action in window.menuBar().actions() if (menu := _menu_of(action)) is not None]
    while menus:
        menu, above = menus.pop(0)
        place = f"{above} › {plain(menu.title())}" if above else plain(menu.title())
        for action in menu.actions():
            if (below := _menu_of(action)) is not None:
                menus.append((below, place))
            elif action not in known and action.isVisible() and not action.isSeparator():
                yield Entry(action, (plain(action.text()),), place, shown_keys((action.shortcut().toString(),)))


def _menu_of(action: QAction) -> QMenu | None:
    menu = action.menu()
    return menu if isinstance(menu, QMenu) else None
