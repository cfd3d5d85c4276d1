"""The rows of the dope sheet: the scene and the layers, and below each its properties."""

from dataclasses import dataclass
from enum import StrEnum

from kagezou.animation.track import Track
from kagezou.document.address import Address, track_of
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Document
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER


class RowKind(StrEnum):
    """What a row stands for."""

    SCENE = "scene"
    LAYER = "layer"
    PROPERTY = "property"


@dataclass(frozen=True, slots=True)
class Row:
    """One row.

    Parameters
    ----------
    kind, layer_id
        ``layer_id`` is None for the scene and its properties.
    addresses
        One property, or all keyed ones of a group, whose keys it sums up.
    is_open
        Whether a group shows its properties.
    """

    kind: RowKind
    layer_id: str | None
    addresses: tuple[Address, ...]
    is_open: bool = False

    @property
    def is_group(self) -> bool:
        """Whether the row sums up others."""
        return self.kind is not RowKind.PROPERTY


@dataclass(frozen=True, slots=True)
class Reveal:
    """Which properties are shown.

    Parameters
    ----------
    names
        These, keyed or not; None for those that are keyed.
    changed
        With no names: those that are not at their default, keyed or not.
    """

    names: frozenset[str] | None = None
    changed: bool = False

    def shows(self, track: Track, address: Address) -> bool:
        """Return whether a property is shown."""
        if self.names is not None:
            return address.property.name in self.names
        return track.is_keyed or (self.changed and track.constant != address.property.default)


def rows_of(document: Document, closed: frozenset[str | None], reveal: Reveal) -> tuple[Row, ...]:
    """Return the rows from top to bottom: the scene, then the layers as they lie, the topmost first.

    Parameters
    ----------
    closed
        The groups that are folded, by layer id; None is the scene.
    reveal
        Which properties are shown.
    """
    rows = list(_group(document, RowKind.SCENE, None, closed, reveal))
    for layer in reversed(document.layers):
        rows += _group(document, RowKind.LAYER, layer.id, closed, reveal)
    return tuple(rows)


def keys_on(document: Document, row: Row, frame: int) -> Refs:
    """Return the keys of a row on one frame."""
    found = (KeyRef(address, frame) for address in row.addresses if track_of(document, address).key_at(frame))
    return frozenset(found)


def frames_of(document: Document, row: Row) -> dict[int, int]:
    """Return how many of the row's properties have a key, by frame."""
    counts: dict[int, int] = {}
    for address in row.addresses:
        for key in track_of(document, address).keys:
            counts[key.frame] = counts.get(key.frame, 0) + 1
    return counts


def _group(
    document: Document, kind: RowKind, layer_id: str | None, closed: frozenset[str | None], reveal: Reveal
) -> list[Row]:
    table = OF_DOCUMENT if layer_id is None else OF_LAYER
    tracks = document.tracks if layer_id is None else document.layer(layer_id).tracks
    # Only what was ever set has a track; asking for all others would cost 200 layers their speed.
    names = (name for name in table if name in tracks or (reveal.names and name in reveal.names))
    known = [Address(table[name], layer_id) for name in names]
    shown = [address for address in known if reveal.shows(track_of(document, address), address)]
    keyed = tuple(address for address in known if track_of(document, address).is_keyed)
    is_open = layer_id not in closed
    rows = [Row(kind, layer_id, keyed, is_open)]
    if is_open:
        rows += [Row(RowKind.PROPERTY, layer_id, (address,)) for address in shown]
    return rows
