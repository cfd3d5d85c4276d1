"""Which rows are shown, how high they are, and how far they are scrolled: shared by the names and the lanes."""

from collections.abc import Iterator

from PySide6.QtCore import QObject, Signal

from kagezou.animation.track import Track
from kagezou.document.address import track_of
from kagezou.document.model import Document
from kagezou.scene.stances import stances_of
from kagezou.ui.system.bridge import Bridge
from kagezou.ui.timeline.rows import Reveal, RowKind, TimelineRow, rows_of


class RowList(QObject):
    """The rows of the session at hand.

    Parameters
    ----------
    bridge
        The session.
    """

    changed = Signal()
    """What is drawn of the rows over time is another: which there are, their drawings, where their keys lie."""
    values_changed = Signal()
    """Nothing but values of properties that are shown."""

    def __init__(self, bridge: Bridge) -> None:
        super().__init__()
        self._bridge = bridge
        self._closed: frozenset[str | None] = frozenset()
        self._scroll_px = 0
        self._room_px = 200
        self.row_px = 22
        self.reveal = Reveal()
        self.rows: tuple[TimelineRow, ...] = ()
        self._shown: tuple[object, ...] = ()
        self._tracks: tuple[Track, ...] = ()
        bridge.document_changed.connect(self._refill)
        bridge.session_replaced.connect(self._begin_anew)
        self._refill()

    @property
    def scroll_px(self) -> int:
        """How far the first row lies above the widget's edge."""
        return min(self._scroll_px, self.furthest_px)

    @property
    def furthest_px(self) -> int:
        """The largest scroll."""
        return max(len(self.rows) * self.row_px - self._room_px, 0)

    def set_room(self, height_px: int) -> None:
        """Take note of the height there is."""
        if height_px != self._room_px:
            self._room_px = height_px
            self.changed.emit()

    def scroll_to(self, scroll_px: int) -> None:
        """Scroll, as far as there are rows."""
        scroll_px = min(max(scroll_px, 0), self.furthest_px)
        if scroll_px != self._scroll_px:
            self._scroll_px = scroll_px
            self.changed.emit()

    def index_at(self, y: float) -> int | None:
        """Return the index of the row at a widget y."""
        index = int((y + self.scroll_px) // self.row_px)
        return index if 0 <= index < len(self.rows) else None

    def top_of(self, index: int) -> int:
        """Return the widget y of a row's upper edge."""
        return index * self.row_px - self.scroll_px

    def seen(self) -> range:
        """Return the indices of the rows that are within the room there is."""
        first = self.scroll_px // self.row_px
        return range(first, min(first + self._room_px // self.row_px + 2, len(self.rows)))

    def fold(self, row: TimelineRow) -> None:
        """Show or hide the properties of a group."""
        self._closed = self._closed ^ {row.group}
        self._refill()

    def fold_all(self, row: TimelineRow) -> None:
        """Show or hide the properties of all groups as this one is about to."""
        groups = frozenset(each.group for each in self.rows if each.is_group)
        self._closed = groups if row.is_open else frozenset()
        self._refill()

    def show_only(self, reveal: Reveal) -> None:
        """Show other properties, and open the scene and the layer worked on."""
        self.reveal = reveal
        self._closed -= {None, self._bridge.layer_id, f"set:{self._bridge.piece_id}"}
        self._refill()
        self._scroll_to_layer()

    def _scroll_to_layer(self) -> None:
        for index, row in enumerate(self.rows):
            if row.is_about(self._bridge.layer_ids, self._bridge.piece_id):
                top = index * self.row_px
                if not self._scroll_px <= top < self._scroll_px + self._room_px - 2 * self.row_px:
                    self.scroll_to(top)

    def _begin_anew(self) -> None:
        self._closed, self._scroll_px, self.reveal = frozenset(), 0, Reveal()
        self._refill()

    def _refill(self) -> None:
        document = self._bridge.document
        rows = rows_of(document, self._closed, self.reveal)
        shown = (rows, document.work_area, document.markers, document.linked, *_drawings_of(document, rows))
        tracks = tuple(track_of(document, address) for row in rows for address in row.addresses)
        # A drag on the picture tells many times a second; what is seen here mostly stays.
        is_drawn_alike = is_same(shown, self._shown) and _have_like_keys(tracks, self._tracks)
        has_like_values = is_same(tracks, self._tracks)
        self.rows, self._shown, self._tracks = rows, shown, tracks
        if not is_drawn_alike:
            self.changed.emit()
        elif not has_like_values:
            self.values_changed.emit()


def is_same(now: tuple[object, ...], before: tuple[object, ...]) -> bool:
    """Whether nothing changed; values that an edit left alone are the very same objects, so that this is quick."""
    return len(now) == len(before) and all(a is b or a == b for a, b in zip(now, before, strict=True))


def _drawings_of(document: Document, rows: tuple[TimelineRow, ...]) -> Iterator[object]:
    """Yield what the lanes draw of layers: their drawings with their names."""
    yield document.canvas
    for row in rows:
        if row.kind is RowKind.LAYER and row.layer_id is not None:
            layer = document.layer(row.layer_id)
            yield layer.cels
            yield layer.name
            yield layer.marks
        elif row.kind is RowKind.FEET and row.layer_id is not None:
            yield stances_of(document, row.layer_id)


def _have_like_keys(now: tuple[Track, ...], before: tuple[Track, ...]) -> bool:
    """Whether keys lie on the same frames and look alike, whatever their values."""
    return len(now) == len(before) and all(
        a is b or _key_shapes(a) == _key_shapes(b) for a, b in zip(now, before, strict=True)
    )


def _key_shapes(track: Track) -> list[object]:
    return [(key.frame, key.interpolation) for key in track.keys]
