"""The main window: puts the parts together and connects them, and knows nothing else."""

from pathlib import Path

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDragLeaveEvent, QDropEvent, QKeyEvent
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QVBoxLayout, QWidget

from kagezou.document.model import Document
from kagezou.ui.project.demo import MakeDemo
from kagezou.ui.project.open_project import OpenProject
from kagezou.ui.system.alt_key import AltKey
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.settings import Settings
from kagezou.ui.window.bars import TopBars
from kagezou.ui.window.docks import Docks
from kagezou.ui.window.drop_hint import DropHint, drop_words
from kagezou.ui.window.panel_layout import TabKey
from kagezou.ui.window.parts import make_parts
from kagezou.ui.window.wiring.cut import connect_cut
from kagezou.ui.window.wiring.figures import connect_feet, connect_transform
from kagezou.ui.window.wiring.first_cut import connect_first_cut
from kagezou.ui.window.wiring.handles import connect_handles
from kagezou.ui.window.wiring.help import connect_help
from kagezou.ui.window.wiring.layers import connect_layers
from kagezou.ui.window.wiring.lost_pointers import let_go_of_all
from kagezou.ui.window.wiring.match import connect_match
from kagezou.ui.window.wiring.preferences import connect_preferences
from kagezou.ui.window.wiring.project_and_frame import connect_frame, connect_messages, connect_project, connect_view
from kagezou.ui.window.wiring.review import connect_review
from kagezou.ui.window.wiring.set_import import connect_set_import
from kagezou.ui.window.wiring.sets import connect_set
from kagezou.ui.window.wiring.support import connect_support
from kagezou.ui.window.wiring.time import (
    connect_curves,
    connect_drawings,
    connect_jumps,
    connect_keys,
    connect_playback,
    connect_timeline,
)
from kagezou.ui.window.wiring.view import connect_lock, connect_resolution, connect_sheets, connect_views


class MainWindow(QMainWindow):
    """One window over the open project; may be thrown away and made anew while the project stays.

    Parameters
    ----------
    open_project
        The project.
    settings
        What is remembered.
    clipboard
        Where copies go.
    make_demo
        Who makes the demo; without it none is offered.

    Attributes
    ----------
    parts
        What the window is made of.
    pages
        The picture, or the first page.
    docks
        The panels at its sides.
    review
        What looks the cut through.
    help
        What opens the manual.
    """

    language_chosen = Signal(str)

    def __init__(
        self,
        open_project: OpenProject,
        settings: Settings,
        clipboard: Clipboard,
        make_demo: MakeDemo | None = None,
    ) -> None:
        super().__init__()
        self._may_close_unasked = False
        self._kept: Document | None = None
        self.parts = make_parts(self, open_project, settings, clipboard, make_demo)
        self.parts.welcome.offer_demo(offered=make_demo is not None)
        self.pages = QStackedWidget()
        self._lay_out()
        self.docks = Docks(self, self.parts)
        self._connect()
        self.show_title()
        self.docks.restore(settings)
        connect_frame(self.parts, self.docks.layout, self)
        connect_handles(self.parts, self.docks.layout)
        self.review = connect_review(self, self.parts, self.docks.layout)
        self.help = connect_help(self, self.parts)
        connect_first_cut(self, self.parts, self.docks.layout)
        self.alt_key = AltKey(self)
        self.alt_key.pen_left.connect(lambda: let_go_of_all(self.parts, self))
        TabKey(self, self.parts.actions["hide_docks"], lambda: not open_project.is_blank)
        self.show_page()

    def show_title(self) -> None:
        """Show the project's name, and whether it is saved or being saved."""
        open_project, project = self.parts.open_project, self.parts.project
        under_way = self.tr("(saving…)") if project.saving.is_running else ""
        self.setWindowTitle(f"{project.project_name}[*] {under_way}".rstrip() + " — Kagezou")
        self.setWindowModified(not open_project.is_saved)
        self.setWindowFilePath(str(open_project.path) if open_project.path else "")

    def show_page(self) -> None:
        """Show the picture, or where to begin while there is none."""
        parts = self.parts
        blank = parts.open_project.is_blank
        if blank:
            parts.welcome.show_recent(parts.settings.recent)
        # On the first page panels would only be empty.
        self.docks.layout.hide(blank, "blank")
        self.pages.setCurrentWidget(parts.welcome if blank else parts.viewport)
        parts.time.transport.setVisible(not blank)
        for panel in (parts.panels.inspector, parts.panels.styles, parts.time.timeline, parts.curves):
            panel.setEnabled(not blank)
        for name in ("save_as", "export", "delete", "rename_layer", "play"):
            parts.actions[name].setEnabled(not blank)
        parts.actions["no_background"].setEnabled(parts.bridge.document.background is not None)

    def show_handles(self) -> None:
        """Show the handles if they are wanted; while the cut runs they would only stand in the way of seeing it."""
        is_free = not self.parts.time.player.is_playing and not self.parts.sets.corner_sheet.is_on
        shown = self.parts.actions["handles"].isChecked() and is_free
        self.parts.viewport.show_handles(shown=shown)

    def show_full_screen(self, on: bool) -> None:
        """Fill the screen, or go back."""
        if on:
            self.showFullScreen()
        else:
            self.showNormal()

    def choose_language(self, code: str) -> None:
        """Tell the program that another language is wanted; "" is the system's."""
        self.language_chosen.emit(code)

    def close_unasked(self) -> None:
        """Close without the question about unsaved work: the open project stays, only the window goes."""
        self._may_close_unasked = True
        self.close()

    def close_without_question(self, kept: Document) -> None:
        """Ask nothing when closed while the document is this one, which is kept where it is found again."""
        self._kept = kept

    def closeEvent(self, event: QCloseEvent) -> None:
        self.parts.time.player.stop()
        self.parts.viewport.controller.cancel()
        is_kept = self._kept is self.parts.bridge.document
        if not self._may_close_unasked and not is_kept and not self.parts.project.may_leave():
            event.ignore()
            return
        self.parts.finish()
        self.alt_key.finish()
        self.docks.remember(self.parts.settings)
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            # Wherever the keyboard is, Escape ends what the hand was given for a while.
            self.parts.viewport.controller.laid_down.emit()
        elif not self.parts.space.press(event):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if not self.parts.space.release(event):
            super().keyReleaseEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() is QEvent.Type.ActivationChange and not self.isActiveWindow():
            self.parts.space.forget()
            let_go_of_all(self.parts, self)
        super().changeEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if paths := _files(event):
            event.acceptProposedAction()
            self._show_drop(drop_words(paths))

    def dragLeaveEvent(self, event: QDragLeaveEvent) -> None:
        self._show_drop(None)

    def dropEvent(self, event: QDropEvent) -> None:
        self._show_drop(None)
        event.acceptProposedAction()
        self.parts.project.bring(_files(event))

    def _show_drop(self, words: str | None) -> None:
        blank = self.parts.open_project.is_blank
        self.parts.welcome.show_hovered(words if blank else None)
        self.drop_hint.show_words(None if blank else words)

    def _lay_out(self) -> None:
        parts = self.parts
        self.pages.addWidget(parts.welcome)
        self.pages.addWidget(parts.viewport)
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(parts.review_bar)
        column.addWidget(self.pages, 1)
        column.addWidget(parts.time.transport)
        self.setCentralWidget(middle)
        self.top_bars = TopBars(
            self.pages, (parts.bar, parts.project.loading, parts.files.canvas_offer, parts.sets.bar)
        )
        parts.viewport.controller.changed.connect(lambda: self.top_bars.step_aside(parts.viewport.controller.is_busy))
        self.drop_hint = DropHint(middle)
        self.addToolBar(parts.menus.tool_bar())
        self.setStatusBar(parts.status)
        self.setAcceptDrops(True)

    def _connect(self) -> None:
        parts = self.parts
        connect_project(parts, self)
        connect_set(parts, self)
        connect_cut(parts)
        connect_layers(parts)
        connect_preferences(parts, self)
        connect_view(parts, self)
        connect_views(parts)
        connect_resolution(parts)
        connect_lock(parts)
        connect_sheets(parts)
        connect_match(parts)
        connect_transform(parts)
        connect_feet(parts)
        connect_set_import(parts)
        connect_playback(parts, self)
        connect_jumps(parts)
        connect_keys(parts)
        connect_drawings(parts)
        connect_timeline(parts)
        connect_curves(parts, self.docks.layout)
        connect_messages(parts)
        connect_support(parts)


def _files(event: QDropEvent) -> list[Path]:
    return [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
