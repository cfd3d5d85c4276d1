"""What the curve editor shows, apart from the document: shared by its parts."""

from PySide6.QtCore import QObject, Signal

from kagezou.document.model import Document
from kagezou.document.remembered import Remembered
from kagezou.tools.curves.curve_list import Curve, curves_of
from kagezou.tools.curves.picture import GraphKind, ShownCurves
from kagezou.ui.system.bridge import Bridge

_MOST_TRACKS = 1024


class Choice(QObject):
    """Which curves are shown, how, and beside which other version of the document.

    Parameters
    ----------
    bridge
        The session.
    """

    changed = Signal()

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._hidden: frozenset[tuple[str, str | None, str | None, int]] = frozenset()
        self._listed_of: Document | None = None
        self._listed_for: tuple[object, ...] = ()
        self._listed: tuple[Curve, ...] = ()
        self._counts: Remembered[int] = Remembered(_MOST_TRACKS)
        self.kind = GraphKind.VALUE
        self.normalises = False
        self.isolates = False
        self.snapshot: Document | None = None
        self.shows_snapshot = False
        bridge.session_replaced.connect(self._begin_anew)
        bridge.lock_changed.connect(self.changed)

    @property
    def is_locked(self) -> bool:
        """Whether the curves can only be looked at."""
        return self._bridge.is_locked

    @property
    def all(self) -> tuple[Curve, ...]:
        """Every curve there is."""
        bridge = self._bridge
        asked = (bridge.layer_id, bridge.piece_id, bridge.layer_ids[1:])
        # Asked several times for each document.
        if self._listed_of is not bridge.document or self._listed_for != asked:
            self._listed_of, self._listed_for = bridge.document, asked
            self._listed = curves_of(bridge.document, *asked, counts=self._counts)
        return self._listed

    @property
    def shown(self) -> tuple[Curve, ...]:
        """The curves that are drawn: those not hidden, and alone those with selected keys when isolating."""
        seen = tuple(curve for curve in self.all if not self.is_hidden(curve))
        chosen = {ref.address for ref in self._bridge.session.state.keys}
        alone = tuple(curve for curve in seen if curve.address in chosen)
        return alone if self.isolates and alone else seen

    @property
    def now(self) -> ShownCurves:
        """What is drawn, as a value."""
        return ShownCurves(self.shown, self.kind, self.normalises, self.ghost)

    @property
    def ghost(self) -> Document | None:
        """The other version, if it is shown."""
        return self.snapshot if self.shows_snapshot else None

    def is_hidden(self, curve: Curve) -> bool:
        """Return whether a curve was switched off."""
        return _key(curve) in self._hidden

    def show(self, curves: tuple[Curve, ...], *, shown: bool) -> None:
        """Switch curves on or off."""
        keys = {_key(curve) for curve in curves}
        self._hidden = self._hidden - keys if shown else self._hidden | keys
        self.changed.emit()

    def set(self, **what: object) -> None:
        """Change one of the public choices by its name."""
        for name, value in what.items():
            setattr(self, name, value)
        self.changed.emit()

    def _begin_anew(self) -> None:
        self._counts.forget()
        self._hidden, self.snapshot, self.isolates = frozenset(), None, False
        self.changed.emit()


def _key(curve: Curve) -> tuple[str, str | None, str | None, int]:
    address = curve.address
    return address.property.name, address.layer_id, address.piece_id, curve.component
