"""Small files of large pictures take at most twice their pixels and 300 MB; what is beyond all bounds is refused.

Each is read in a process of its own, whose largest memory is asked for.
"""

import struct
import subprocess
import sys
import zlib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from kagezou.errors import InputProblem
from kagezou.io.files.memory import free_memory
from kagezou.io.images import picture_size
from kagezou.io.images.reading import probe, read_cel
from tests.io.images import picture_files as files
from tests.io.images import raw_files as raw

MB = 1 << 20
SPARE_MB = 300
_READ = """
import sys
from pathlib import Path
from kagezou.errors import Problem
import {module} as module

def most():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))

before = most()
try:
    module.{name}(Path(sys.argv[1]))
except Problem as problem:
    print(problem, file=sys.stderr)
print((most() - before) >> 10)
"""
linux_alone = pytest.mark.skipif(sys.platform != "linux", reason="the largest memory is asked for by /proc")


def taken_mb(path: Path, name: str = "read_cel", module: str = "kagezou.io.images.reading") -> tuple[int, str]:
    """The memory that reading took at most, and what was said."""
    script = _READ.format(module=module, name=name)
    done = subprocess.run([sys.executable, "-c", script, str(path)], capture_output=True, text=True, check=True)
    return int(done.stdout), done.stderr.strip()


def png_of_zeros(path: Path, side: int, kind: int, channels: int, extra: bytes = b"") -> None:
    packer = zlib.compressobj(9)
    row = bytes(1 + side * channels)
    body = b"".join(packer.compress(row) for _ in range(side)) + packer.flush()
    head = struct.pack(">IIBBBBB", side, side, 8, kind, 0, 0, 0)
    chunks = files.chunk(b"IHDR", head) + extra + files.chunk(b"IDAT", body) + files.chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunks)


def tga_of_runs(path: Path, side: int, kind: int, pixel: bytes, palette: bytes = b"") -> None:
    row = (b"\xff" + pixel) * (side // 128)
    head = struct.pack(
        "<BBBHHBHHHHBB", 0, bool(palette), kind, 0, len(palette) // 4, 32, 0, 0, side, side, 8 * len(pixel), 8
    )
    path.write_bytes(head + palette + row * side)


def webp_of_one_colour(path: Path, width: int, height: int) -> None:
    """A lossless WebP of about 30 bytes."""
    bits = [0, 0, 0]
    for value in (200, 30, 90, 255, 2):
        bits += [1, 0, 1, *(value >> place & 1 for place in range(8))]
    bits += [0] * (-len(bits) % 8)
    packed = bytes(sum(bits[at + place] << place for place in range(8)) for at in range(0, len(bits), 8))
    body = b"\x2f" + struct.pack("<I", (width - 1) | (height - 1) << 14 | 1 << 28) + packed
    chunk = b"VP8L" + struct.pack("<I", len(body)) + body + bytes(len(body) % 2)
    path.write_bytes(b"RIFF" + struct.pack("<I", 4 + len(chunk)) + b"WEBP" + chunk)


SIDE = 9984
"""Of pictures that take about 400 MB."""

BOMBS: dict[str, Callable[[Path], object]] = {
    "rgba.png": lambda path: png_of_zeros(path, SIDE, 6, 4),
    "gray.png": lambda path: png_of_zeros(path, SIDE, 0, 1),
    "runs.tga": lambda path: tga_of_runs(path, SIDE, 10, b"\1\2\3\xff"),
    "palette.tga": lambda path: tga_of_runs(path, SIDE, 9, b"\1", bytes(8)),
    "a.gif": lambda path: Image.new("P", (SIDE, SIDE)).save(path),
    "a.webp": lambda path: webp_of_one_colour(path, 8192, 8192),
    "a.jpg": lambda path: Image.new("RGB", (SIDE, SIDE), (9, 9, 9)).save(path, quality=1, progressive=True),
    "a.exr": lambda path: files.save(path, np.zeros((5000, 5000, 4), np.float16), straight=False),
}


@linux_alone
@pytest.mark.parametrize("name", BOMBS)
def test_a_large_picture_takes_twice_its_pixels(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    BOMBS[name](path)
    info = probe(path)
    pixels = info.width_px * info.height_px * (8 if name == "a.exr" else 4)
    assert path.stat().st_size < 100 * MB
    most, said = taken_mb(path)
    assert said == ""
    assert most < 2 * pixels // MB + SPARE_MB


@linux_alone
@pytest.mark.parametrize("name", [b"iCCP", b"zTXt", b"iTXt"])
def test_text_that_grows_is_not_unpacked(tmp_path: Path, name: bytes) -> None:
    head = b"x\0\1\0\0\0" if name == b"iTXt" else b"x\0\0"
    extra = files.chunk(name, head + zlib.compress(bytes(400 * MB), 9))
    path = tmp_path / "a.png"
    path.write_bytes(files.png((4, 4), 8, 2, bytes(4 * 13), extra))
    assert taken_mb(path)[0] < SPARE_MB


@linux_alone
def test_a_webp_beyond_the_bound_is_refused(tmp_path: Path) -> None:
    webp_of_one_colour(tmp_path / "a.webp", 16383, 16383)
    most, said = taken_mb(tmp_path / "a.webp")
    assert said.endswith("a.webp: 16383 × 16383 px is larger than can be read")
    assert most < 50


@linux_alone
@pytest.mark.parametrize(
    ("value", "count"), [("[]", 9_000_000), ("{}", 9_000_000), ("1", 15_000_000), ('"😀"', 500_000)]
)
def test_a_project_of_nothing_but_values(tmp_path: Path, value: str, count: int) -> None:
    path = tmp_path / "a.kage"
    path.write_text("[" + f"{value}," * count + "0]", encoding="utf-8")
    most, said = taken_mb(path, "load", "kagezou.io.project.file")
    assert said.startswith(f"{path}: ")
    assert most < SPARE_MB


def test_more_than_the_memory_that_is_free_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.tif"
    path.write_bytes(raw.tiff(np.zeros((600, 700, 4), np.uint8), 2, 8, extras=(2,), packing=8))
    read_cel(path)
    monkeypatch.setattr(picture_size, "free_memory", lambda: 3 * MB)
    with pytest.raises(InputProblem, match="700 × 600 px need 3 MB of memory to be read, of which 3 MB are free"):
        read_cel(path)


def test_free_memory_is_known() -> None:
    found = free_memory()
    assert found is None or found > 10 * MB
