"""The inspector: every property of the table, for the scene and for the layer or set piece worked on."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from kagezou.document import properties
from kagezou.document.address import Address
from kagezou.document.figure_properties import HOLD, LEAST_PART, LIFT_LINES, PLACEMENT_LINES, SHADOWS_UNITE
from kagezou.document.piece_kinds import kind_of, matters
from kagezou.document.properties import TABLE
from kagezou.document.property import AnyProperty, Scope
from kagezou.document.set_properties import SET_BLEND, SET_COLOR, SET_OPACITY
from kagezou.document.values import value_at
from kagezou.scene.evaluate import camera_at, ground_at
from kagezou.scene.figure_card import card_at
from kagezou.ui.panels.piece_sections import PieceName, piece_sections
from kagezou.ui.panels.property_row import PropertyRow
from kagezou.ui.panels.row_menu import PropertyMenus
from kagezou.ui.panels.section import Section
from kagezou.ui.panels.wave_note import WaveNote
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.clipboard import Clipboard
from kagezou.ui.widgets.retiring import retire

_ONLY_FOR_LIGHT = {
    properties.LIGHT_POSITION.name: "point",
    properties.OVERHEAD_RADIUS.name: "point",
    properties.OVERHEAD_SIMPLIFY.name: "point",
    properties.LIGHT_STEP.name: "point",
    properties.LIGHT_AZIMUTH.name: "sun",
    properties.LIGHT_ELEVATION.name: "sun",
}
"""Properties that mean nothing for the other kind of light and are hidden then."""

_SHAPE = (
    properties.SIMPLIFY_ON, properties.SIMPLIFY, properties.DISTANCE, properties.ELONGATION, HOLD, LEAST_PART,
    properties.GROW, properties.SOFTNESS, properties.PENUMBRA,
)  # fmt: skip
_SHADOW_OF_SET = (SET_COLOR, SET_OPACITY, SET_BLEND)
_FADING = (properties.FADE, properties.FADE_CURVE, properties.TIP_COLOR, properties.TIP_DISTANCE)
_OF_A_PART = frozenset((properties.VISIBLE, properties.RECEIVES, *PLACEMENT_LINES))
"""What a part of another layer's figure has of its own."""

_GROUPS: Mapping[str, tuple[AnyProperty, ...]] = MappingProxyType({
    "placement": PLACEMENT_LINES, "shape": _SHAPE, "fading": _FADING, "jump": LIFT_LINES, "light": (SHADOWS_UNITE,),
})  # fmt: skip
"""Sections whose lines are not told by the names of their properties."""


class Inspector(QScrollArea):
    """Iterates the property table; a new line there appears here by itself."""

    def __init__(self, bridge: Bridge, clipboard: Clipboard) -> None:
        super().__init__()
        self._bridge = bridge
        self.menus = PropertyMenus(clipboard)
        self._built_for: tuple[object, ...] | None = None
        self._folded: frozenset[str] = frozenset()
        self._scene_sections: list[Section] = []
        self._layer_sections: list[Section] = []
        self.owner: PieceName | None = None
        self.waves: WaveNote | None = None
        self._inner = QWidget()
        self._column = QVBoxLayout(self._inner)
        self._column.setContentsMargins(0, 0, 0, 0)
        self._column.setSpacing(1)
        self.chosen = QLabel()
        self.chosen.setObjectName("several_layers")
        self.chosen.setWordWrap(True)
        self.chosen.hide()
        self._column.addWidget(self.chosen)
        self._column.addStretch(1)
        self.setWidget(self._inner)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        bridge.document_changed.connect(self._refresh)
        bridge.frame_changed.connect(self._refresh)
        bridge.selection_changed.connect(self._refresh)
        self._scene_sections = self._sections(Scope.DOCUMENT, None)
        self._refresh()

    @property
    def rows(self) -> list[PropertyRow]:
        """Every row there is now, hidden ones included."""
        return [row for section in (*self._layer_sections, *self._scene_sections) for row in section.rows]

    def row(self, name: str) -> PropertyRow:
        """Return the row of a property by its name in the table."""
        return next(row for row in self.rows if row.address.property.name == name)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        # Rows that were just put in are shown, and have a width, only once Qt lays them out.
        if watched is self._inner and event.type() is QEvent.Type.LayoutRequest:
            bar = self.verticalScrollBar().sizeHint().width()
            self.setMinimumWidth(self._inner.minimumSizeHint().width() + bar)
        return super().eventFilter(watched, event)

    def _refresh(self) -> None:
        self._follow_selection()
        for row in self.rows:
            row.refresh()
        if self.waves is not None:
            self.waves.refresh()
        if self.owner is not None:
            self.owner.refresh()
        self._show_relevant()
        self._show_measured_tilt()

    def _follow_selection(self) -> None:
        ids = self._bridge.layer_ids
        joins = tuple(self._bridge.document.layer(each).joins for each in ids)
        wanted = (self._bridge.session, ids, joins, self._bridge.piece_id)
        if wanted == self._built_for:
            return
        self._built_for = wanted
        for section in self._layer_sections:
            self._folded = self._folded - {section.title} if section.is_open else self._folded | {section.title}
        old = (*self._layer_sections, *([self.owner] if self.owner else []))
        for part in old:
            self._column.removeWidget(part)
        retire(old)
        layer_id = self._bridge.layer_id
        self._layer_sections = [] if layer_id is None else self._sections(Scope.LAYER, layer_id)
        self._show_several()
        self.waves = None if layer_id is None else WaveNote(self._bridge, self._bridge.layer_ids)
        if self.waves is not None:
            of_waves = [each for each in self._layer_sections if each.rows[0].address.property is properties.WAVES_ON]
            of_waves[0].add_note(self.waves)
        self._follow_piece()
        for section in self._layer_sections:
            section.open(opened=section.title not in self._folded)
        _align([*self._scene_sections, *self._layer_sections])

    def _follow_piece(self) -> None:
        """Put the piece worked on before the scene, and the shadow of the set, which is its too, behind it."""
        piece_id = self._bridge.piece_id
        self.owner = None if piece_id is None else PieceName(self._bridge, piece_id)
        of_set = next(each for each in self._scene_sections if each.rows[0].address.property in _SHADOW_OF_SET)
        self._column.removeWidget(of_set)
        if piece_id is None or self.owner is None:
            self._column.insertWidget(self._column.count() - 1, of_set)
            return
        self._layer_sections = piece_sections(self._bridge, piece_id, self.menus)
        for at, part in enumerate((self.owner, *self._layer_sections, of_set), 1):
            self._column.insertWidget(at, part)

    def _sections(self, scope: Scope, layer_id: str | None) -> list[Section]:
        made: dict[str, Section] = {}
        # Behind the line that says how many layers are chosen.
        before_scene = 1 if scope is Scope.LAYER else self._column.count() - 1
        others = self._bridge.layer_ids[1:] if scope is Scope.LAYER else ()
        for prop in TABLE:
            if prop.scope is not scope:
                continue
            title = self._title(prop)
            if title not in made:
                made[title] = Section(title, self.menus)
                self._column.insertWidget(before_scene + len(made) - 1, made[title])
            twins = tuple(Address(prop, other) for other in others)
            made[title].add(PropertyRow(self._bridge, Address(prop, layer_id), self.menus, twins))
        return list(made.values())

    def _title(self, prop: AnyProperty) -> str:
        titles: dict[str, Callable[[], str]] = {
            "camera": lambda: self.tr("Camera"),
            "background": lambda: self.tr("Background"),
            "ground": lambda: self.tr("Ground"),
            "light": lambda: self.tr("Light"),
            "shadow": lambda: self.tr("Shadow"),
            "shape": lambda: self.tr("Shape"),
            "fading": lambda: self.tr("Fading"),
            "placement": lambda: self.tr("Placement"),
            "jump": lambda: self.tr("In a jump"),
            "waves": lambda: self.tr("Waves"),
            "contact": lambda: self.tr("Contact with the ground"),
            "reflection": lambda: self.tr("Reflection"),
            "set.shadow": lambda: self.tr("Shadow of the set"),
            "": lambda: self.tr("Character"),
        }
        return titles[_group_of(prop)]()

    def _show_several(self) -> None:
        ids = self._bridge.layer_ids
        names = ", ".join(self._bridge.document.layer(each).name for each in ids)
        document = self._bridge.document
        figure_id = document.layer(ids[0]).joins if len(ids) == 1 else None
        self.chosen.setVisible(len(ids) > 1 or figure_id is not None)
        if figure_id is not None:
            words = self.tr("Part of %1, which has the shadow of both")
            self.chosen.setText(words.replace("%1", document.layer(figure_id).name))
        else:
            self.chosen.setText(self.tr("%1 layers together: %2").replace("%1", str(len(ids))).replace("%2", names))

    def _show_relevant(self) -> None:
        document, frame = self._bridge.document, self._bridge.frame
        kind = value_at(document.tracks, properties.LIGHT_KIND, frame)
        for row in self.rows:
            prop, piece_id = row.address.property, row.address.piece_id
            needed = _ONLY_FOR_LIGHT.get(prop.name, kind)
            is_of_kind = piece_id is None or matters(prop, kind_of(document.piece(piece_id), frame))
            row.set_visible(visible=needed == kind and is_of_kind and self._is_its_own(prop))
        for section in self._layer_sections:
            section.setVisible(any(self._is_its_own(row.address.property) for row in section.rows))

    def _is_its_own(self, prop: AnyProperty) -> bool:
        """Return whether a property means anything for the layers chosen: a part shares its figure's shadow."""
        ids, document = self._bridge.layer_ids, self._bridge.document
        if prop.scope is not Scope.LAYER or prop in _OF_A_PART:
            return True
        return any(document.layer(each).joins is None for each in ids)

    def _show_measured_tilt(self) -> None:
        """Show the tilt that two grounding points measure, which then cannot be set (spec 2)."""
        ids = self._bridge.layer_ids
        if not ids:
            return
        document, frame = self._bridge.document, self._bridge.frame
        camera, ground = camera_at(document, frame), ground_at(document, frame)
        cards = [card_at(document, document.layer(each), frame, camera, ground) for each in ids]
        row = self.row(properties.TILT.name)
        row.set_editable(editable=not any(card.is_tilt_measured for card in cards))
        if len(cards) == 1 and cards[0].is_tilt_measured:
            row.editor.show_value(cards[0].tilt_deg)


def _group_of(prop: AnyProperty) -> str:
    """Return which section a property is shown in."""
    group, _, last = prop.name.rpartition(".")
    for title, lines in _GROUPS.items():
        if prop in lines:
            return title
    return "waves" if last.startswith(("wave", "slit")) or group.startswith("shadow.wave") else group


def _align(sections: list[Section]) -> None:
    width = max((row.label.sizeHint().width() for section in sections for row in section.rows), default=0)
    for section in sections:
        section.align(width)
