"""The status bar: a hint at the left, canvas, zoom and what draws at the right."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtWidgets import QLabel, QStatusBar, QToolButton, QWidget

from kagezou.scene.figure_card import feet_at
from kagezou.tools.readout import height_words
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.system.words import translated

_SAID_MS = 6000


class Status(QStatusBar):
    """Says quietly what is looked at.

    Parameters
    ----------
    bridge
        The session shown.
    extra
        A widget beside the hint, such as an export's progress.

    Attributes
    ----------
    canvas
        The size of the picture; a click asks for another.
    """

    def __init__(self, bridge: Bridge, extra: QWidget) -> None:
        super().__init__()
        self._bridge = bridge
        self._memory_words: Callable[[], str] = str
        self._hint = QLabel()
        self._height = QLabel()
        self._height.setToolTip(self.tr("How high the figure is over the ground on this frame"))
        self.canvas = QToolButton()
        self.canvas.setAutoRaise(True)
        self.canvas.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.canvas.setToolTip(self.tr("Size of the picture; a click opens the settings of the cut"))
        self._zoom = QLabel()
        self._resolution = QLabel()
        self._resolution.setToolTip(self.tr("Preview resolution; exports are always full"))
        self._device = QLabel()
        self._work = QLabel()
        self._work.hide()
        self._lock = QLabel(self.tr("Look Only"))
        self._lock.setObjectName("look_only")
        self._lock.hide()
        self.setSizeGripEnabled(False)
        self.addWidget(self._hint, 1)
        for widget in (self._lock, self._work, extra, self._height, *self.labels):
            self.addPermanentWidget(widget)
        bridge.document_changed.connect(self._show_document)
        bridge.selection_changed.connect(self._show_document)
        for changed in (bridge.document_changed, bridge.selection_changed, bridge.frame_changed):
            changed.connect(self._show_height)
        self._show_document()
        self._show_height()

    def show_work(self, done: int, whole: int) -> None:
        """Say how far the search for feet beside the window is; 0 of 0 when it is done."""
        self._work.setVisible(whole > 0)
        counts = {"%1": done, "%2": whole}
        words = self.tr("Looking for feet: %1 of %2")
        for place, count in counts.items():
            words = words.replace(place, str(count))
        self._work.setText(words)

    def watch_memory(self, words: Callable[[], str]) -> None:
        """Say under the hand, on the zoom, what ``words`` returns at that moment."""
        self._memory_words = words
        self._zoom.setToolTip(words())
        self._zoom.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Make the words of a label anew as they are about to be shown."""
        if event.type() is QEvent.Type.ToolTip and watched is self._zoom:
            self._zoom.setToolTip(self._memory_words())
        return super().eventFilter(watched, event)

    def say(self, words: str) -> None:
        """Say for a while that something is done."""
        self.showMessage(words, _SAID_MS)

    def show_locked(self, *, locked: bool) -> None:
        """Say that nothing can be changed."""
        self._lock.setVisible(locked)

    @property
    def labels(self) -> tuple[QLabel | QToolButton, ...]:
        """What stands at the right, from left to right."""
        return (self._resolution, self._device, self.canvas, self._zoom)

    def show_zoom(self, percent: float) -> None:
        """Say how large the picture is shown."""
        self._zoom.setText(f"{percent:.0f} %" if percent >= 10 else f"{percent:.1f} %")

    def show_divisor(self, divisor: int) -> None:
        """Say when the picture is drawn at a part of its resolution: it is how many px across become one."""
        self._resolution.setText(f"1/{divisor}" if divisor > 1 else "")

    def show_device(self, name: str, is_software: bool) -> None:
        """Say when the processor draws instead of a graphics card."""
        self._device.setText(self.tr("software rendering") if is_software else "")
        self._device.setToolTip(name)

    def _show_height(self) -> None:
        bridge = self._bridge
        words = None if bridge.layer_id is None else height_words(bridge.document, bridge.layer_id, bridge.frame)
        self._height.setText("" if words is None else translated(words))
        self._height.setVisible(words is not None)

    def _show_document(self) -> None:
        document = self._bridge.document
        canvas = document.canvas
        self.canvas.setText(f"{canvas.width_px} × {canvas.height_px}")
        is_blank = not document.layers and document.background is None
        for label in self.labels:
            label.setVisible(not is_blank)
        if self._bridge.piece_id is not None:
            self._hint.setText(
                self.tr("Drag an edge to move the set piece, the arrows to size it, the lever at its front to turn it")
            )
        elif not document.layers:
            self._hint.setText("")
        else:
            self._hint.setText(
                self.tr(
                    "Drag the light to move the shadow; right-click a foot to say what it does, double-click to add one"
                )
                if self._stands_on_feet()
                else self.tr(
                    "Drag the light to move the shadow; double-click on the character to add a grounding point"
                )
            )

    def _stands_on_feet(self) -> bool:
        document, layer_id = self._bridge.document, self._bridge.layer_id
        if layer_id is None:
            return False
        figure = document.layer(document.layer(layer_id).joins or layer_id)
        return feet_at(document, figure, self._bridge.frame) is not None
