"""What is said of plain PNG files is what OpenImageIO says of them; of others it is asked."""

import dataclasses
import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from kagezou.errors import InputProblem
from kagezou.io.images import plain_png as module
from kagezou.io.images.oiio_guard import DecodedPicture
from kagezou.io.images.opening import opened
from kagezou.io.images.plain_png import PlainPng, plain_png
from tests.io.images import picture_files as files
from tests.io.images.test_fast_png import GRAY, PALETTE, RGB, RGBA, SIZE, rows_of

PLAIN = {
    "nothing": b"",
    "sRGB": files.chunk(b"sRGB", b"\0"),
    "usual gamma": files.chunk(b"gAMA", struct.pack(">I", 45455)),
    "linear": files.chunk(b"gAMA", struct.pack(">I", 100000)),
    "primaries": files.chunk(b"cHRM", struct.pack(">8I", 31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000)),
    "numbers": files.chunk(b"cICP", bytes([12, 13, 0, 1])),
    "unknown numbers": files.chunk(b"cICP", bytes([12, 16, 0, 1])),
    "resolution": files.chunk(b"pHYs", struct.pack(">IIB", 3780, 3780, 1)),
    "time": files.chunk(b"tIME", struct.pack(">HBBBBB", 2026, 1, 2, 3, 4, 5)),
    "background": files.chunk(b"bKGD", bytes(6)),
}
OTHER = {
    "colour key": files.chunk(b"tRNS", bytes(6)),
    "words": files.chunk(b"tEXt", b"Orientation\0006"),
    "profile": files.chunk(b"iCCP", b"p\0\0" + b"x\x9c\3\0\0\0\0\1"),
    "turned": files.chunk(b"eXIf", b"MM\0*\0\0\0\10\0\1\1\22\0\3\0\0\0\1\0\6\0\0\0\0\0\0"),
    "film": files.chunk(b"acTL", struct.pack(">II", 2, 0)),
    "own": files.chunk(b"abCd", b"?"),
}


@pytest.fixture
def path(tmp_path: Path) -> Path:
    return tmp_path / "a.png"


@pytest.mark.parametrize("kind", [RGB, RGBA])
@pytest.mark.parametrize("name", PLAIN)
def test_header_and_pixels_are_those_of_the_other_decoder(path: Path, kind: int, name: str) -> None:
    path.write_bytes(files.png(SIZE, 8, kind, rows_of(kind), PLAIN[name]))
    plain = plain_png(path)
    assert plain is not None
    assert plain.pictures() == 1
    with DecodedPicture(path) as other:
        mine, theirs = (dataclasses.asdict(each.header) for each in (plain, other))
        for either in (mine, theirs):
            either["notes"] = [str(note) for note in either["notes"]]
        assert (plain.header.change is None) == (other.header.change is None)
        assert {**mine, "change": None} == {**theirs, "change": None}
        assert plain.header.change is other.header.change
        assert np.array_equal(plain.used(), other.used())
        if kind == RGBA:
            assert np.array_equal(plain.alpha(), other.alpha())


@pytest.mark.parametrize("name", OTHER)
def test_what_may_hold_more_is_for_the_other_decoder(path: Path, name: str) -> None:
    path.write_bytes(files.png(SIZE, 8, RGB, rows_of(RGB), OTHER[name]))
    assert plain_png(path) is None
    with opened(path) as picture:
        assert not isinstance(picture, PlainPng)


def test_other_kinds_are_for_the_other_decoder(path: Path) -> None:
    for kind, bits in ((GRAY, 8), (PALETTE, 8), (RGB, 16), (RGBA, 16)):
        extra = files.chunk(b"PLTE", bytes(768)) if kind == PALETTE else b""
        path.write_bytes(files.png(SIZE, bits, kind, rows_of(kind, bits), extra))
        assert plain_png(path) is None


def test_what_the_fast_decoder_leaves_is_read_all_the_same(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path.write_bytes(files.png(SIZE, 8, RGBA, rows_of(RGBA)))
    monkeypatch.setattr(module, "fast_pixels", lambda *_: None)
    with opened(path) as picture:
        assert isinstance(picture, PlainPng)
        assert np.array_equal(picture.used(), files.read_back(path))


def test_a_file_that_goes_away_is_told(path: Path) -> None:
    with pytest.raises(InputProblem):
        plain_png(path)


def test_no_other_decoder_is_loaded_for_them(path: Path) -> None:
    path.write_bytes(files.png(SIZE, 8, RGBA, rows_of(RGBA)))
    script = (
        "import sys; from pathlib import Path; from kagezou.io.images.reading import read_cel, read_matte; "
        "read_cel(Path(sys.argv[1])); read_matte(Path(sys.argv[1])); "
        "print(sorted({'OpenImageIO', 'PIL', 'psd_tools'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", script, str(path)], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
