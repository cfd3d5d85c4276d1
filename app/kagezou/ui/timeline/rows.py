"""The rows of the dope sheet: the scene and the layers, and below each its properties."""

from collections.abc import Collection
from dataclasses import dataclass, replace
from enum import StrEnum

from kagezou.document.address import Address, track_of, usual_value
from kagezou.document.key_edits import KeyRef, Refs
from kagezou.document.model import Document
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.scene.stances import stances_of


class RowKind(StrEnum):
    """What a row stands for."""

    SCENE = "scene"
    LAYER = "layer"
    FEET = "feet"
    PIECE = "piece"
    PROPERTY = "property"


@dataclass(frozen=True, slots=True)
class TimelineRow:
    """One row.

    Parameters
    ----------
    kind, layer_id, piece_id
        Both ids are None for the scene and its properties.
    addresses
        One property, or all keyed ones of a group, whose keys it sums up.
    is_open
        Whether a group shows its properties.
    """

    kind: RowKind
    layer_id: str | None
    addresses: tuple[Address, ...]
    is_open: bool = False
    piece_id: str | None = None

    @property
    def group(self) -> str | None:
        """What its group is folded by; ids of layers and pieces never meet."""
        return self.layer_id if self.piece_id is None else f"set:{self.piece_id}"

    @property
    def is_group(self) -> bool:
        """Whether the row sums up others."""
        return self.kind not in (RowKind.PROPERTY, RowKind.FEET)

    def is_about(self, layer_ids: Collection[str], piece_id: str | None) -> bool:
        """Whether it stands for a layer that is chosen or the set piece worked on."""
        if self.kind is RowKind.PIECE:
            return self.piece_id == piece_id
        return self.kind is RowKind.LAYER and self.layer_id in layer_ids


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

    def shows(self, document: Document, address: Address) -> bool:
        """Return whether a property is shown."""
        track = track_of(document, address)
        if self.names is not None:
            return address.property.name in self.names
        return track.is_keyed or (self.changed and track.constant != usual_value(document, address))


def rows_of(document: Document, closed: frozenset[str | None], reveal: Reveal) -> tuple[TimelineRow, ...]:
    """Return the rows from top to bottom: the scene, then the layers as they lie, the topmost first.

    Parameters
    ----------
    closed
        The groups that are folded, by `TimelineRow.group`; None is the scene.
    reveal
        Which properties are shown.
    """
    groups = [TimelineRow(RowKind.SCENE, None, ())]
    groups += [TimelineRow(RowKind.PIECE, None, (), piece_id=piece.id) for piece in document.pieces]
    groups += [TimelineRow(RowKind.LAYER, layer.id, ()) for layer in reversed(document.layers)]
    return tuple(row for group in groups for row in _group(document, group, closed, reveal))


def keys_on(document: Document, row: TimelineRow, frame: int) -> Refs:
    """Return the keys of a row on one frame."""
    found = (KeyRef(address, frame) for address in row.addresses if track_of(document, address).key_at(frame))
    return frozenset(found)


def frames_of(document: Document, row: TimelineRow) -> dict[int, int]:
    """Return how many of the row's properties have a key, by frame."""
    counts: dict[int, int] = {}
    for address in row.addresses:
        for key in track_of(document, address).keys:
            counts[key.frame] = counts.get(key.frame, 0) + 1
    return counts


def _group(document: Document, group: TimelineRow, closed: frozenset[str | None], reveal: Reveal) -> list[TimelineRow]:
    if group.piece_id is not None:
        table, tracks = OF_PIECE, document.piece(group.piece_id).tracks
    elif group.layer_id is not None:
        table, tracks = OF_LAYER, document.layer(group.layer_id).tracks
    else:
        table, tracks = OF_DOCUMENT, document.tracks
    # Only what was ever set has a track; asking for all others would cost 200 layers their speed.
    names = (name for name in table if name in tracks or (reveal.names and name in reveal.names))
    known = [Address(table[name], group.layer_id, group.piece_id) for name in names]
    shown = [address for address in known if reveal.shows(document, address)]
    keyed = tuple(address for address in known if track_of(document, address).is_keyed)
    is_open = group.group not in closed
    rows = [replace(group, addresses=keyed, is_open=is_open)]
    if is_open and group.layer_id is not None and _has_feet(document, group.layer_id):
        rows.append(TimelineRow(RowKind.FEET, group.layer_id, ()))
    if is_open:
        rows += [
            TimelineRow(RowKind.PROPERTY, group.layer_id, (address,), piece_id=group.piece_id) for address in shown
        ]
    return rows


def _has_feet(document: Document, layer_id: str) -> bool:
    return document.layer(layer_id).joins is None and stances_of(document, layer_id) is not None
