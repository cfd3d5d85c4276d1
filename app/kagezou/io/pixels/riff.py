"""The chunks of a WebP file, which is a RIFF file."""

import io
from collections.abc import Iterator
from typing import BinaryIO, Final

_HEAD_BYTES: Final = 12
_MOST_CHUNKS: Final = 100_000
_FRAME_HEAD_BYTES: Final = 16
_FLAGS_AT: Final = 20
_HAS_ALPHA: Final = 0x10
_TO_BACKGROUND: Final = 1


def chunks_of(stream: BinaryIO) -> Iterator[tuple[bytes, int, bytes]]:
    """Yield the name, the length and the first bytes of each chunk of a WebP file that is in the stream."""
    stream.seek(_HEAD_BYTES)
    for _ in range(_MOST_CHUNKS):
        head = stream.read(8)
        if len(head) < 8:
            return
        length = int.from_bytes(head[4:], "little")
        start = stream.read(min(length, _FRAME_HEAD_BYTES))
        yield head[:4], length, start
        stream.seek(length - len(start) + length % 2, 1)


def durations_ms(stream: BinaryIO) -> tuple[float, ...]:
    """Return how long each picture of a WebP film is seen."""
    return tuple(
        float(int.from_bytes(start[12:15], "little"))
        for name, _, start in chunks_of(stream)
        if name == b"ANMF" and len(start) >= 15
    )


def with_open_alpha(data: bytes) -> bytes:
    """Return a WebP film that says that it has alpha where its pictures leave parts of the canvas clear.

    Encoders leave that out where every picture, cut to what is in it, is opaque.
    """
    found = {name: start for name, _, start in chunks_of(io.BytesIO(data[: _FLAGS_AT + _FRAME_HEAD_BYTES]))}
    head = found.get(b"VP8X", b"")
    if len(head) < 10 or head[0] & _HAS_ALPHA:
        return data
    canvas = head[4:10]
    frames = [start for name, _, start in chunks_of(io.BytesIO(data)) if name == b"ANMF" and len(start) == 16]
    covers = [start[6:12] == canvas and not any(start[:6]) for start in frames]
    disposes = any(start[15] & _TO_BACKGROUND for start in frames)
    if not frames or all(covers) or (covers[0] and not disposes):
        return data
    return data[:_FLAGS_AT] + bytes([data[_FLAGS_AT] | _HAS_ALPHA]) + data[_FLAGS_AT + 1 :]
