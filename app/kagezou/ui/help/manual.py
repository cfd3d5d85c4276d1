"""The manual: its pages beside a list of them, opened where something is explained."""

from collections.abc import Iterable, Mapping
from typing import Any, Final

from PySide6.QtCore import QByteArray, QEvent, Qt, QUrl
from PySide6.QtGui import QFont, QImage, QTextBlock, QTextCursor, QTextDocument, QTextFormat
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSplitter,
    QTextBrowser,
    QTextEdit,
    QVBoxLayout,
    QWidget,
)

from kagezou.document.property import AnyProperty
from kagezou.locations import manual_folder
from kagezou.ui.help.pages import FIRST, Page, pages_in, with_properties
from kagezou.ui.system.language import language_code
from kagezou.ui.system.theme import CHANGED, CHOSEN, WELL
from kagezou.ui.widgets.tool_button import tool_button

_LETTERS: Final = (112, 40)
_LIST_LETTERS: Final = 24
_MARGIN_PX: Final = 18.0
_PICTURE_PX: Final = 640
"""The most that a picture is wide, so that it needs no scrolling beside the list."""


def page_of(url: QUrl) -> str:
    """Return the name of the page that a link leads to."""
    return url.fileName().removesuffix(".md")


class Pages(QTextBrowser):
    """Shows a page of the manual; links lead to others, and to the web.

    Parameters
    ----------
    pages
        Every page by name.
    sections
        The properties of each section of the inspector, by the section's name.
    """

    def __init__(self, pages: Mapping[str, Page], sections: Mapping[str, Iterable[AnyProperty]]) -> None:
        super().__init__()
        self._pages = pages
        self._sections = sections
        self.setOpenExternalLinks(True)
        self.setSearchPaths([str(manual_folder() / language_code()), str(manual_folder() / "en")])
        self.document().setDocumentMargin(_MARGIN_PX)
        self.document().setDefaultStyleSheet(f"a {{ color: {CHANGED.name()}; }}")

    @property
    def page(self) -> str:
        """The name of the page that is shown."""
        return page_of(self.source())

    def loadResource(self, kind: int, name: QUrl | str) -> Any:
        # A page is not the file as it lies there: its properties are written from the table.
        page = self._pages.get(page_of(QUrl(name)))
        if kind == QTextDocument.ResourceType.MarkdownResource.value and page is not None:
            return QByteArray(with_properties(page.text, self._sections).encode())
        found = super().loadResource(kind, name)
        if kind == QTextDocument.ResourceType.ImageResource.value and isinstance(found, QByteArray):
            picture = QImage.fromData(found)
            if picture.width() > _PICTURE_PX:
                return picture.scaledToWidth(_PICTURE_PX, Qt.TransformationMode.SmoothTransformation)
        return found

    def doSetSource(
        self,
        name: QUrl | str,
        type: QTextDocument.ResourceType = QTextDocument.ResourceType.UnknownResource,  # noqa: A002 - as Qt calls it
    ) -> None:
        super().doSetSource(name, type)
        _set_apart(self.document())

    def open(self, name: str, term: str = "") -> None:
        """Show a page, and bring where it explains a term to the top; without one, its beginning."""
        self.setSource(QUrl(f"{name}.md"), QTextDocument.ResourceType.MarkdownResource)
        self.setExtraSelections([])
        block = self._explaining(term) if term else None
        if block is None:
            self.verticalScrollBar().setValue(0)
        else:
            self._show_block(block)

    @property
    def marked(self) -> str:
        """The words of the paragraph that was asked for; empty if none was, or the page has none."""
        selections = self.extraSelections()
        return selections[0].cursor.block().text() if selections else ""

    def _explaining(self, term: str) -> QTextBlock | None:
        """Return the paragraph that begins with a term in bold; a heading explains nothing."""
        block = self.document().begin()
        while block.isValid():
            fragments = block.begin()
            if not fragments.atEnd() and not block.blockFormat().headingLevel():
                first = fragments.fragment()
                is_bold = first.charFormat().fontWeight() > QFont.Weight.Normal
                if is_bold and first.text() == term:
                    return block
            block = block.next()
        return None

    def _show_block(self, block: QTextBlock) -> None:
        selection = QTextEdit.ExtraSelection()
        cursor = QTextCursor(block)
        cursor.clearSelection()
        selection.cursor = cursor
        selection.format.setBackground(CHOSEN)
        selection.format.setProperty(QTextFormat.Property.FullWidthSelection, True)
        self.setExtraSelections([selection])
        top = self.document().documentLayout().blockBoundingRect(block).top()
        self.verticalScrollBar().setValue(int(top - _MARGIN_PX))


def _set_apart(document: QTextDocument) -> None:
    """Set the lines of programs apart from the text, and let long ones go on below, so that nothing is scrolled."""
    block, is_first = document.begin(), True
    while block.isValid():
        shape, after = block.blockFormat(), block.next()
        if shape.nonBreakableLines():
            is_last = not after.isValid() or not after.blockFormat().nonBreakableLines()
            shape.setNonBreakableLines(False)
            shape.setLeftMargin(_MARGIN_PX)
            shape.setTopMargin(_MARGIN_PX / 2 if is_first else 0)
            shape.setBottomMargin(_MARGIN_PX / 2 if is_last else 0)
            QTextCursor(block).setBlockFormat(shape)
            is_first = is_last
        block = after


class Manual(QWidget):
    """A window of its own, so that the picture stays in sight.

    Parameters
    ----------
    sections
        The properties of each section of the inspector, by the section's name.
    parent
        The window or dialog that it explains; it goes with it.

    Attributes
    ----------
    pages, contents, search
        The page, the list of pages, and the field that leaves only pages with some words in the list.
    """

    def __init__(self, sections: Mapping[str, Iterable[AnyProperty]], parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setWindowTitle(self.tr("Kagezou Manual"))
        self._known = pages_in(language_code())
        self.pages = Pages(self._known, sections)
        self.contents = QListWidget()
        self.search = QLineEdit()
        self.search.setPlaceholderText(self.tr("Search"))
        self.search.setClearButtonEnabled(True)
        for page in self._known.values():
            item = QListWidgetItem(page.title, self.contents)
            item.setData(Qt.ItemDataRole.UserRole, page.name)
        self._lay_out()
        self.search.textChanged.connect(self._filter)
        self.contents.itemActivated.connect(lambda item: self.open(item.data(Qt.ItemDataRole.UserRole)))
        self.contents.itemClicked.connect(lambda item: self.open(item.data(Qt.ItemDataRole.UserRole)))
        self.pages.sourceChanged.connect(lambda url: self._show_place(page_of(url)))

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all pages."""
        return tuple(self._known)

    def open(self, name: str = FIRST, term: str = "") -> None:
        """Show a page at a term, and come to the front."""
        # Shown first: a page has its heights, and so the place of a term, only once it is laid out.
        self.show()
        self.raise_()
        self.activateWindow()
        self.pages.open(name if name in self._known else FIRST, term)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() is QEvent.Type.FontChange:
            self._size()
        super().changeEvent(event)

    def _lay_out(self) -> None:
        tools = QHBoxLayout()
        tools.setSpacing(2)
        back = tool_button("undo", self.tr("Back"), self.pages.backward, small=True)
        forward = tool_button("redo", self.tr("Forward"), self.pages.forward, small=True)
        for button, possible in ((back, self.pages.backwardAvailable), (forward, self.pages.forwardAvailable)):
            button.setEnabled(False)
            possible.connect(button.setEnabled)
            tools.addWidget(button)
        tools.addWidget(self.search, 1)
        left = QWidget()
        column = QVBoxLayout(left)
        column.setContentsMargins(6, 6, 6, 6)
        column.addLayout(tools)
        column.addWidget(self.contents, 1)
        halves = QSplitter()
        halves.addWidget(left)
        halves.addWidget(self.pages)
        halves.setStretchFactor(1, 1)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(halves)
        self.pages.setStyleSheet(f"QTextBrowser {{ background: {WELL.name()}; border: none; }}")
        self._size()
        halves.setSizes([_LIST_LETTERS * self._letter, (_LETTERS[0] - _LIST_LETTERS) * self._letter])

    @property
    def _letter(self) -> int:
        return self.fontMetrics().averageCharWidth()

    def _size(self) -> None:
        wide, high = _LETTERS[0] * self._letter, _LETTERS[1] * self.fontMetrics().height()
        screen = self.screen().availableGeometry()
        self.resize(min(wide, screen.width()), min(high, screen.height()))

    def _filter(self, words: str) -> None:
        wanted = words.casefold().split()
        for row in range(self.contents.count()):
            item = self.contents.item(row)
            text = self._known[item.data(Qt.ItemDataRole.UserRole)].text.casefold()
            item.setHidden(not all(word in text for word in wanted))

    def _show_place(self, name: str) -> None:
        for row in range(self.contents.count()):
            if self.contents.item(row).data(Qt.ItemDataRole.UserRole) == name:
                self.contents.setCurrentRow(row)
