"""What keys, ends and the playhead catch on while they are dragged."""

from bisect import bisect_left

from kagezou.document.address import addresses, track_of
from kagezou.document.key_edits import Refs
from kagezou.document.model import Document

SNAP_PX = 7.0


def snap_frames(document: Document, playhead: int, without: Refs = frozenset()) -> tuple[int, ...]:
    """Return the frames that catch, in order: keys, exposures, markers, the ends of cut and work area, the playhead.

    Parameters
    ----------
    without
        Keys that are being dragged and so catch nothing.
    """
    dragged = {(ref.address, ref.frame) for ref in without}
    frames = {1, document.canvas.length_frames, playhead, *document.played}
    frames.update(marker.frame for marker in document.markers)
    for layer in document.layers:
        frames.update(max(exposure.frame, 1) for exposure in layer.cels.exposures)
    keyed = {*document.tracks, *(name for layer in document.layers for name in layer.tracks)}
    for address in addresses(document):
        if address.property.name in keyed:
            track = track_of(document, address)
            frames.update(key.frame for key in track.keys if (address, key.frame) not in dragged)
    return tuple(sorted(frames))


def snapped(position: float, frames: tuple[int, ...], cell_px: float) -> tuple[int, int | None]:
    """Return the frame a dragged thing lands on, and the frame that caught it, if one did.

    Parameters
    ----------
    position
        Where it would lie, in frames.
    frames
        What catches, in order.
    cell_px
        The width of a frame; what is farther than ``SNAP_PX`` does not catch.
    """
    index = bisect_left(frames, position)
    near = min(frames[max(index - 1, 0) : index + 1], key=lambda frame: abs(frame - position), default=None)
    if near is not None and abs(near - position) * cell_px <= max(SNAP_PX, cell_px / 2):
        return near, near
    return round(position), None
