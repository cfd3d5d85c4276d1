"""Looking a cut through: picture and curves large, nothing to be changed, from note to note and from flag to flag."""

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabBar, QToolBar

from kagezou.ui.curves.remarks import Remark, remark_words, remarks_of
from kagezou.ui.curves.review_bar import ReviewBar
from kagezou.ui.widgets.message_bar import MessageBar, Severity
from kagezou.ui.window.panel_layout import PanelLayout
from kagezou.ui.window.parts import Parts

if TYPE_CHECKING:
    from kagezou.ui.curves.curve_editor import CurveEditor

_CURVES_SHARE = 38
"""Of 100 parts of the window's height."""


class ReviewMode(QObject):
    """Turns a review on and off, and walks through what is to be looked at; walking needs no review.

    Parameters
    ----------
    window
        Whose panels make room.
    parts
        What is shown.
    layout
        What hides the panels and brings them back.
    """

    def __init__(self, window: QMainWindow, parts: Parts, layout: PanelLayout) -> None:
        super().__init__(window)
        self._window, self._parts, self._layout = window, parts, layout
        self._bridge = parts.bridge
        self._was_locked = self._had_handles = False
        self.is_on = False
        self.current: Remark | None = None
        self.escape = QShortcut(QKeySequence(Qt.Key.Key_Escape), window, self._leave)
        self.escape.setEnabled(False)
        bar = self.bar
        bar.previous.clicked.connect(lambda: self.step(-1))
        bar.following.clicked.connect(lambda: self.step(1))
        bar.tick_asked.connect(lambda _on: self.tick())
        bar.answer.clicked.connect(self._answer)
        bar.add.clicked.connect(self._add)
        bar.leave.clicked.connect(self._leave)
        self._bridge.document_changed.connect(self._follow)
        self._bridge.session_replaced.connect(self._leave)
        self._bridge.lock_changed.connect(lambda on: None if on else self._leave())

    @property
    def bar(self) -> ReviewBar:
        """The bar over the picture."""
        return self._parts.review_bar

    @property
    def remarks(self) -> tuple[Remark, ...]:
        """What there is to look at."""
        return remarks_of(self._bridge.document, self._editor.flags.flags)

    def turn(self, on: bool) -> None:
        """Begin a review, or end it; then everything is as it was."""
        if on == self.is_on:
            return
        self.is_on = on
        editor = self._editor
        handles = self._parts.actions["handles"]
        if on:
            self._was_locked, self._had_handles = self._bridge.is_locked, handles.isChecked()
        self._bridge.lock(on or self._was_locked)
        handles.setChecked(self._had_handles and not on)
        editor.annotating.review(on=on)
        editor.show_for_review(on=on)
        editor.show_list(notes=True)
        self.escape.setEnabled(on)
        self.bar.setVisible(on)
        self._make_room(on)
        self._show()

    def step(self, by: int) -> None:
        """Go to the next remark, or with -1 to the one before; at the ends it stays."""
        remarks = self.remarks
        if not remarks:
            self._say(self.tr("There are no notes, and nothing stands out."))
            return
        if self.current in remarks:
            number = remarks.index(self.current) + by
        elif by > 0:
            number = next((n for n, each in enumerate(remarks) if each.frame >= self._bridge.frame), len(remarks))
        else:
            number = sum(each.frame <= self._bridge.frame for each in remarks) - 1
        if not 0 <= number < len(remarks):
            self._say(self.tr("This is the last one.") if by > 0 else self.tr("This is the first one."))
            number = min(max(number, 0), len(remarks) - 1)
        self._go_to(remarks[number])

    def tick(self) -> None:
        """Tick the note that is looked at off, or take its tick away."""
        note = None if self.current is None else self.current.note
        if note is None:
            self._say(self.tr("Go to a note first."))
            return
        self.current = Remark(note.frame, note=replace(note, is_done=not note.is_done))
        self._editor.notes.tick(note, done=not note.is_done)
        self._follow()

    @property
    def _editor(self) -> "CurveEditor":
        return self._parts.curves.made()

    def _go_to(self, remark: Remark) -> None:
        self.current = remark
        editor, session = self._editor, self._bridge.session
        if remark.note is not None:
            if remark.note.layer_id is not None and remark.note.layer_id not in self._bridge.layer_ids:
                session.select(remark.note.layer_id)
            session.go_to(remark.frame)
            editor.notes.choose(remark.note)
        elif remark.flag is not None:
            editor.flags.go_to(remark.flag)
        editor.show_list(notes=remark.note is not None)
        self._show()
        if not self.is_on:
            self._say(remark_words(remark, self._bridge.document))

    def _follow(self) -> None:
        """Stay at the note that was answered or changed; a flag may be gone."""
        if self.current is None:
            return
        if self.current.note is not None:
            now = next((each for each in self._bridge.document.notes if each.is_as(self.current.note)), None)
            self.current = None if now is None else Remark(now.frame, note=now)
        if self.is_on:
            self._show()

    def _show(self) -> None:
        if not self.is_on:
            return
        remarks, current = self.remarks, self.current
        if current is None or current not in remarks:
            words = self.tr("Notes: %1, flags: %2")
            notes = sum(each.note is not None for each in remarks)
            words = words.replace("%1", str(notes)).replace("%2", str(len(remarks) - notes))
            self.bar.show_remark("", words, is_note=False, is_done=False)
            return
        place = f"{remarks.index(current) + 1} / {len(remarks)}"
        is_done = current.note is not None and current.note.is_done
        words = remark_words(current, self._bridge.document)
        self.bar.show_remark(place, words, is_note=current.note is not None, is_done=is_done)

    def _make_room(self, on: bool) -> None:
        self._layout.hide(on, "review")
        if not on:
            return
        for bar in self._window.findChildren(QToolBar):
            bar.hide()
        dock = self._window.findChild(QDockWidget, "curves")
        if isinstance(dock, QDockWidget):
            dock.show()
            dock.raise_()
            # Qt leaves the tabs of hidden panels beside it where they were.
            for tabs in self._window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly):
                tabs.hide()
            height = self._window.height() * _CURVES_SHARE // 100
            self._window.resizeDocks([dock], [height], Qt.Orientation.Vertical)

    def _add(self) -> None:
        # The editor is made when it is first wanted.
        self._editor.notes.ask_new()

    def _answer(self) -> None:
        if self.current is not None and self.current.note is not None:
            self._editor.notes.choose(self.current.note)
            self._editor.notes.ask_answer()

    def _leave(self) -> None:
        if self.is_on:
            self._parts.actions["review"].setChecked(False)

    def _say(self, words: str) -> None:
        bar: MessageBar = self._parts.bar
        bar.say("review", words, Severity.NOTE)
