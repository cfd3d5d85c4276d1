"""The inspector: every property of the table, the light first, for the scene and the layer or set piece worked on."""

from collections.abc import Collection, Iterable
from itertools import chain

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.changes import tracks_changed
from kagezou.document.model import Document
from kagezou.document.properties import TABLE
from kagezou.document.property import Scope
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.figure_card import card_at
from kagezou.ui.panels.edited_property import EditedProperty
from kagezou.ui.panels.folds import Folds
from kagezou.ui.panels.groups import Group, group_of
from kagezou.ui.panels.meaning import decides_meaning, meaning_on
from kagezou.ui.panels.piece_name import PieceName
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.panels.section import Section
from kagezou.ui.panels.wave_note import WaveNote
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.system.words import translated
from kagezou.ui.widgets.retiring import retire
from kagezou.ui.widgets.scrub_field import ScrubLabel


class Inspector(QScrollArea):
    """Iterates the property table; a new line there appears here by itself."""

    def __init__(self, bridge: Bridge, clipboard: Clipboard, folds: Folds | None = None) -> None:
        super().__init__()
        self._bridge, self._folds = bridge, folds or Folds()
        self.menus = PropertyMenus(clipboard)
        self._built_for: tuple[object, ...] | None = None
        self._shown: tuple[Document, int] | None = None
        self.sections: dict[Group, Section] = {}
        """The sections there are now, in the order in which they stand."""
        self.owner: PieceName | None = None
        self.waves: WaveNote | None = None
        self._inner = QWidget()
        self._column = QVBoxLayout(self._inner)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(1)
        self._name = ScrubLabel("")
        """No row's: it measures names of rows."""
        self._name.setParent(self._inner)
        self._name.hide()
        self.chosen = QLabel()
        self.chosen.setObjectName("several_layers")
        self.chosen.setWordWrap(True)
        self.chosen.hide()
        self.setWidget(self._inner)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._inner.installEventFilter(self)
        bridge.document_changed.connect(self._refresh)
        bridge.frame_settled.connect(self._refresh)
        bridge.selection_changed.connect(self._refresh)
        self._fill(Scope.DOCUMENT, (None,))
        self._refresh()

    @property
    def rows(self) -> list[PropertyRow]:
        """Every row that is made by now, hidden ones included."""
        return [row for section in self.sections.values() for row in section.rows]

    @property
    def edited(self) -> list[EditedProperty]:
        """What every row is about, whether it is made or not."""
        return [each for section in self.sections.values() for each in section.edited]

    def row(self, name: str) -> PropertyRow:
        """Return the row of a property by its name in the table, made for it where nobody has seen it yet."""
        address = next(each.address for each in self.edited if each.address.property.name == name)
        return self.sections[group_of(address.property)].rows_of((address,))[0]

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Rows that were just put in are shown, and have a width, only once Qt lays them out.
        if watched is self._inner and event.type() is QEvent.Type.LayoutRequest:
            bar = self.verticalScrollBar().sizeHint().width()
            self.setMinimumWidth(self._inner.minimumSizeHint().width() + bar)
        return super().eventFilter(watched, event)

    def reveal(self, addresses: Iterable[Address]) -> None:
        """Open the sections of properties, bring their rows into sight and mark them; none marks nothing."""
        wanted = set(addresses)
        shown: list[PropertyRow] = []
        for section in self.sections.values():
            shown += section.reveal(wanted)
        for row in self.rows:
            row.show_chosen(chosen=row in shown)
        if shown:
            self._show_relevant()
            self._scroll_to(shown[-1].editor)
            self._scroll_to(shown[0].label)

    def _scroll_to(self, widget: QWidget) -> None:
        # What was just opened has its place only once it is laid out.
        self._column.activate()
        self._inner.adjustSize()
        self.ensureWidgetVisible(widget, 0, 12)

    def _refresh(self) -> None:
        document, frame = self._bridge.document, self._bridge.frame
        is_built_anew = self._follow_selection()
        shown, self._shown = self._shown, (document, frame)
        # While something is dragged it is one of many that are seen here.
        alone = None if is_built_anew or shown is None or shown[1] != frame else tracks_changed(shown[0], document)
        if not self._refresh_rows(alone):
            self._show_relevant()
        if self.waves is not None:
            self.waves.refresh()
        if self.owner is not None:
            self.owner.refresh()
        self._show_measured_tilt()

    def _refresh_rows(self, alone: frozenset[Address] | None) -> bool:
        """Refresh the rows of some properties, None for all; return whether the same ones as before are to be seen."""
        about = self.edited if alone is None else [each for each in self.edited if each.is_about(alone)]
        rows = [row for row in self.rows if row.edited in about]
        were_changed = [row.is_changed for row in rows]
        for row in rows:
            row.refresh()
        # A property whose row is not made yet may have to be shown from now on.
        are_alike = len(rows) == len(about) and were_changed == [row.is_changed for row in rows]
        return alone is not None and are_alike and not decides_meaning(alone)

    def _follow_selection(self) -> bool:
        """Build the rows of what is chosen; return whether they are others than before."""
        ids, piece_id = self._bridge.layer_ids, self._bridge.piece_id
        joins = tuple(self._bridge.document.layer(each).joins for each in ids)
        wanted = (self._bridge.session, ids, joins, piece_id)
        before, self._built_for = self._built_for, wanted
        if wanted == before:
            return False
        self._drop_owned()
        self.owner = None if piece_id is None else PieceName(self._bridge, piece_id)
        self._fill(Scope.PIECE, () if piece_id is None else (piece_id,))
        self._fill(Scope.LAYER, ids)
        self._show_several()
        self.waves = WaveNote(self._bridge, ids) if ids else None
        if self.waves is not None:
            self.sections[Group.WAVES].add_note(self.waves)
        self._put_in_order()
        _align(self.sections.values(), self._name)
        shown = self.sections.get(Group.CHARACTER if ids else Group.PIECE_PLACE)
        if shown is not None and before is not None and before[0] is self._bridge.session and (before[1] or before[3]):
            # Another layer or piece was chosen by hand: it is shown, wherever the panel was.
            self._scroll_to(shown)
        return True

    def _drop_owned(self) -> None:
        """Take away what was about the layer or piece worked on before."""
        scene = {group: each for group, each in self.sections.items() if _is_of_scene(each)}
        gone = [each for each in self.sections.values() if not _is_of_scene(each)]
        old = (*gone, *([self.owner] if self.owner else []))
        for part in old:
            self._column.removeWidget(part)
        retire(old)
        self.sections = scene

    def _fill(self, scope: Scope, ids: tuple[str | None, ...]) -> None:
        """Add the sections of the scene, or of layers or a piece: rows of the first, editing the others with it."""
        for prop in TABLE if ids else ():
            if prop.scope is not scope:
                continue
            group = group_of(prop)
            if group not in self.sections:
                self.sections[group] = self._new_section(group)
            first, *others = (
                Address(prop, piece_id=each) if scope is Scope.PIECE else Address(prop, each) for each in ids
            )
            self.sections[group].add(EditedProperty(self._bridge, first, tuple(others)))

    def _new_section(self, group: Group) -> Section:
        section, folds = Section(group, self.menus), self._folds
        section.open(opened=folds.is_open(group))
        section.show_more(shown=folds.shows_more(group))
        section.folded.connect(lambda opened: folds.set_open(group, opened=opened))
        section.more_asked.connect(lambda shown: folds.set_more(group, shown=shown))
        section.header.toggled.connect(self._show_relevant)
        section.more.toggled.connect(self._show_relevant)
        if group is group_of(properties.TILT):
            section.made.connect(self._show_measured_tilt)
        return section

    def _put_in_order(self) -> None:
        while self._column.count():
            self._column.takeAt(0)
        self.sections = {group: self.sections[group] for group in Group if group in self.sections}
        for group, section in self.sections.items():
            if group is Group.PIECE_PLACE and self.owner is not None:
                self._column.addWidget(self.owner)
            if group is Group.CHARACTER:
                self._column.addWidget(self.chosen)
            self._column.addWidget(section)
        self._column.addStretch(1)

    def _show_several(self) -> None:
        ids, document = self._bridge.layer_ids, self._bridge.document
        names = ", ".join(document.layer(each).name for each in ids)
        figure_id = document.layer(ids[0]).joins if len(ids) == 1 else None
        self.chosen.setVisible(len(ids) > 1 or figure_id is not None)
        if figure_id is not None:
            words = self.tr("Part of %1, which has the shadow of both")
            self.chosen.setText(words.replace("%1", document.layer(figure_id).name))
        else:
            self.chosen.setText(self.tr("%1 layers together: %2").replace("%1", str(len(ids))).replace("%2", names))

    def _show_relevant(self) -> None:
        means_something = meaning_on(self._bridge.document, self._bridge.frame, self._bridge.layer_ids)
        for section in self.sections.values():
            section.show_rows(means_something)

    def _show_measured_tilt(self) -> None:
        """Show the tilt that two grounding points measure, which then cannot be set (spec 2)."""
        row = next((each for each in self.rows if each.address.property is properties.TILT), None)
        if row is None:
            return
        ids, document, frame = self._bridge.layer_ids, self._bridge.document, self._bridge.frame
        camera, ground = camera_at(document, frame), ground_at(document, frame)
        cards = [card_at(document, document.layer(each), frame, camera, ground) for each in ids]
        row.set_editable(editable=not any(card.is_tilt_measured for card in cards))
        if len(cards) == 1 and cards[0].is_tilt_measured:
            row.editor.show_value(cards[0].tilt_deg)


def _is_of_scene(section: Section) -> bool:
    return section.edited[0].address.property.scope is Scope.DOCUMENT


def _align(sections: Collection[Section], name: ScrubLabel) -> None:
    # By all names, so that no section that is opened moves the others.
    width = 0
    for each in chain.from_iterable(section.edited for section in sections):
        name.setText(translated(each.address.property.label))
        width = max(width, name.sizeHint().width())
    for section in sections:
        section.align(width)
