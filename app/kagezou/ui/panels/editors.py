"""One editor a kind of property: shows a value and sends what the hand makes of it, knowing no document."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QLabel, QPushButton, QWidget

from kagezou.animation.track import Value
from kagezou.document.property import AnyProperty, Kind
from kagezou.ui.panels.filter_pictures import tip_of
from kagezou.ui.system.shown_units import shown_unit
from kagezou.ui.system.words import choice_name, translated
from kagezou.ui.widgets.color_button import ColorField
from kagezou.ui.widgets.range_slider import RangeSlider
from kagezou.ui.widgets.scrub_field import MIXED, AxisField, ScrubField


class Editor(QWidget):
    """Shows a value; ``began``, ``tried`` and ``ended`` bracket a drag, ``entered`` is a change at one stroke.

    ``calculated`` is a typed change of each of several values, such as ``*2``, and what the values are shown times.
    """

    began = Signal()
    tried = Signal(object)
    ended = Signal(bool)
    entered = Signal(object)
    calculated = Signal(str, float)

    def __init__(self) -> None:
        super().__init__()
        self.row = QHBoxLayout(self)
        self.row.setContentsMargins(0, 0, 0, 0)
        self.row.setSpacing(4)

    @property
    def scrubbed_by_label(self) -> ScrubField | None:
        """The field that dragging the property's name drags."""
        return None

    def show_value(self, value: Value) -> None:
        """Show a value."""
        raise NotImplementedError

    def show_mixed(self, value: Value) -> None:
        """Show that several values differ; ``value`` is the one that a drag starts from."""
        raise NotImplementedError


class NumbersEditor(Editor):
    """One field a number: a plain number, or the coordinates of a point or place."""

    def __init__(self, prop: AnyProperty) -> None:
        super().__init__()
        self._single = prop.kind is Kind.NUMBER
        step, decimals = _grain(prop)
        self._shown = shown_unit(prop)
        self.fields: list[ScrubField] = [ScrubField(step, decimals, self._shown.unit)]
        if not self._single:
            self.fields = [AxisField(step, decimals, each.upper()) for each in prop.components]
        self._values: list[float] = [0.0] * len(self.fields)
        for index, (field, component) in enumerate(zip(self.fields, prop.components, strict=True)):
            field.set_range(prop.low * self._shown.factor, prop.high * self._shown.factor)
            name = translated(prop.label)
            field.setAccessibleName(name if self._single else f"{name} {component}")
            field.setToolTip(tip_of(prop) if self._single else f"{component.upper()}")
            field.drag_began.connect(self.began)
            field.drag_ended.connect(self.ended)
            field.dragged.connect(lambda number, at=index: self.tried.emit(self._with(at, number)))
            field.entered.connect(lambda number, at=index: self.entered.emit(self._with(at, number)))
            field.calculated.connect(lambda text: self.calculated.emit(text, self._shown.factor))
            axis_px = 0 if self._single else field.fontMetrics().horizontalAdvance("X")
            field.setMinimumWidth(field.fontMetrics().horizontalAdvance("-00000") + 12 + axis_px)
            self.row.addWidget(field, 1)
        self.slider = RangeSlider(*prop.slides) if prop.slides else None
        if self.slider is not None:
            self.slider.setAccessibleName(translated(prop.label))
            self.slider.setToolTip(tip_of(prop))
            self.slider.began.connect(self.began)
            self.slider.tried.connect(self.tried)
            self.slider.ended.connect(self.ended)
            self.slider.entered.connect(self.entered)
            self.row.addWidget(self.slider, 1)

    @property
    def scrubbed_by_label(self) -> ScrubField | None:
        return self.fields[0] if self._single else None

    def show_value(self, value: Value) -> None:
        numbers = value if isinstance(value, tuple) else (value,)
        self._values = [float(number) for number in numbers if isinstance(number, (int, float))]
        for field, number in zip(self.fields, self._values, strict=True):
            field.set_value(round(number * self._shown.factor, 9))
        if self.slider is not None:
            self.slider.show_value(self._values[0])

    def show_mixed(self, value: Value) -> None:
        self.show_value(value)
        for field in self.fields:
            field.show_mixed()

    def _with(self, index: int, number: float) -> Value:
        number /= self._shown.factor
        numbers = [number if at == index else old for at, old in enumerate(self._values)]
        return numbers[0] if self._single else tuple(numbers)


class ChoiceEditor(Editor):
    """A list of words to choose from."""

    def __init__(self, prop: AnyProperty) -> None:
        super().__init__()
        self.combo = QComboBox()
        self.combo.setAccessibleName(translated(prop.label))
        self.combo.setToolTip(tip_of(prop))
        for choice in prop.choices:
            self.combo.addItem(choice_name(choice), choice)
        self.combo.activated.connect(lambda _: self.entered.emit(self.combo.currentData()))
        self.row.addWidget(self.combo, 1)

    def show_value(self, value: Value) -> None:
        self.combo.setCurrentIndex(self.combo.findData(value))

    def show_mixed(self, value: Value) -> None:
        self.combo.setPlaceholderText(MIXED)
        self.combo.setCurrentIndex(-1)


class SwitchEditor(Editor):
    """On or off."""

    def __init__(self, prop: AnyProperty) -> None:
        super().__init__()
        self.box = QCheckBox()
        self.box.setAccessibleName(translated(prop.label))
        self.box.setToolTip(tip_of(prop))
        self.box.clicked.connect(self._enter)
        self.row.addWidget(self.box, 1)

    def show_value(self, value: Value) -> None:
        self.box.setTristate(False)
        self.box.setChecked(bool(value))

    def _enter(self, on: bool) -> None:
        # Connected by itself, the other signal would be sent without the switch's state.
        self.entered.emit(on)

    def show_mixed(self, value: Value) -> None:
        self.box.setCheckState(Qt.CheckState.PartiallyChecked)


class ColorEditor(Editor):
    """A colour."""

    def __init__(self, prop: AnyProperty) -> None:
        super().__init__()
        self.field = ColorField()
        self.field.setToolTip(tip_of(prop))
        self.field.picking_began.connect(self.began)
        self.field.tried.connect(self.tried.emit)
        self.field.picking_ended.connect(self.ended)
        self.field.entered.connect(self.entered.emit)
        self.row.addWidget(self.field, 1)

    def show_value(self, value: Value) -> None:
        self.field.set_color(str(value))

    def show_mixed(self, value: Value) -> None:
        self.field.show_mixed(str(value))


class PointsEditor(Editor):
    """How many points there are, and a way to be rid of them; they are placed in the picture itself."""

    def __init__(self, prop: AnyProperty) -> None:
        super().__init__()
        self._count = QLabel()
        self._count.setToolTip(self.tr("Double-click on the character in the picture to add a grounding point"))
        self._clear = QPushButton(self.tr("Clear"))
        self._clear.setObjectName("small_button")
        self._clear.setAccessibleName(f"{translated(prop.label)}: {self._clear.text()}")
        self._clear.clicked.connect(lambda: self.entered.emit(()))
        self.row.addWidget(self._count, 1)
        self.row.addWidget(self._clear)

    def show_value(self, value: Value) -> None:
        points: Sequence[object] = value if isinstance(value, tuple) else ()
        self._count.setText(self.tr("%n point(s)", "", len(points)) if points else self.tr("none"))
        self._clear.setEnabled(bool(points))

    def show_mixed(self, value: Value) -> None:
        self._count.setText(MIXED)
        self._clear.setEnabled(True)


def editor_for(prop: AnyProperty) -> Editor:
    """Return the editor of a property's kind."""
    match prop.kind:
        case Kind.NUMBER | Kind.POINT | Kind.PLACE:
            return NumbersEditor(prop)
        case Kind.CHOICE:
            return ChoiceEditor(prop)
        case Kind.SWITCH:
            return SwitchEditor(prop)
        case Kind.COLOR:
            return ColorEditor(prop)
        case Kind.POINTS:
            return PointsEditor(prop)


def _grain(prop: AnyProperty) -> tuple[float, int]:
    """Return how much a px of dragging changes, and the digits worth showing, by unit and range."""
    if prop.unit == "px":
        return 1.0, 1
    if prop.unit == "°":
        return 0.25, 2
    if shown_unit(prop).factor != 1.0:
        return 0.5, 1
    span = prop.high - prop.low
    return (0.005, 3) if span <= 10 else (0.5, 2)
