"""What a lead looks for in curves: jumps from frame to frame, and keys that no drawing changes with."""

from dataclasses import dataclass
from enum import StrEnum

from kagezou.animation.curve import largest_steps
from kagezou.document.address import Address, track_of
from kagezou.document.model import Document
from kagezou.document.property import Kind

_MEASURED = (Kind.POINT, Kind.PLACE, Kind.POINTS)


class FlagKind(StrEnum):
    """What is noticed."""

    JUMP = "jump"
    OFF_EXPOSURES = "off exposures"


@dataclass(frozen=True, slots=True)
class Flag:
    """Something to look at.

    Parameters
    ----------
    amount
        How far a value jumps, in px; 0 for the others.
    """

    kind: FlagKind
    frame: int
    address: Address
    amount: float = 0.0


def flags_of(document: Document, addresses: tuple[Address, ...], jump_px: float) -> tuple[Flag, ...]:
    """Return what stands out in some properties, in the order of frames.

    Parameters
    ----------
    jump_px
        Places that move farther than this from one frame to the next jump; a held key is meant to.
    """
    found: list[Flag] = []
    for address in addresses:
        found += _jumps(document, address, jump_px)
        if address.layer_id is not None:
            found += _off_exposures(document, address)
    return tuple(sorted(found, key=lambda flag: (flag.frame, flag.kind, flag.address.property.name)))


def _jumps(document: Document, address: Address, jump_px: float) -> list[Flag]:
    if address.property.kind not in _MEASURED:
        return []
    track = track_of(document, address)
    steps = largest_steps(track, 1, document.canvas.length_frames)
    return [Flag(FlagKind.JUMP, frame, address, step) for frame, step in steps if step > jump_px]


def _off_exposures(document: Document, address: Address) -> list[Flag]:
    """Return the keys on frames on which a layer that is not on ones shows the same drawing as before."""
    cels = document.layer(address.layer_id or "").cels
    changes = {max(exposure.frame, 1) for exposure in cels.exposures}
    if not changes or len(changes) >= document.canvas.length_frames:
        return []
    keys = track_of(document, address).keys
    return [Flag(FlagKind.OFF_EXPOSURES, key.frame, address) for key in keys if key.frame not in changes]
