"""The frames on which something is keyed: the marks on the ruler, and where previous and next key lead."""

from kagezou.document.model import Document


def key_frames(document: Document, layer_id: str | None, piece_id: str | None = None) -> tuple[int, ...]:
    """Return the frames with a key of the scene, or of one layer or set piece, in order and without repeats."""
    tracks = [*document.tracks.values()]
    for layer in document.layers:
        if layer.id == layer_id:
            tracks.extend(layer.tracks.values())
    for piece in document.pieces:
        if piece.id == piece_id:
            tracks.extend(piece.tracks.values())
    return tuple(sorted({key.frame for track in tracks for key in track.keys}))


def previous_key(frames: tuple[int, ...], frame: int) -> int | None:
    """Return the last keyed frame before a frame."""
    return max((each for each in frames if each < frame), default=None)


def next_key(frames: tuple[int, ...], frame: int) -> int | None:
    """Return the first keyed frame after a frame."""
    return min((each for each in frames if each > frame), default=None)
