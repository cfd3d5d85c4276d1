"""Damages files of every format at random and reads them: each must end in what it holds or in one sentence.

    python packaging/dev_mutants.py [COUNT] [SEED] [FORMAT …]

COUNT files a format (2000) are read in child processes, so that a crash or a hang is counted and the others go on. The
program itself reads each USD file in a process of its own; here many share one, and where that one ends, its files are
read again as the program reads them.
"""

import io
import json
import random
import struct
import subprocess
import sys
import tempfile
import zlib
from collections import Counter
from collections.abc import Callable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any, Final

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from PIL import Image

PICTURES: Final = ("tga", "tif", "exr", "webp", "png", "jpg", "gif", "bmp", "psd")
SETS: Final = ("ply", "stl", "obj", "glb", "gltf")
USD: Final = ("usda", "usdc", "usdz")
SHEETS: Final = ("xdts", "sts")
FORMATS: Final = (*PICTURES, *SETS, *USD, *SHEETS)
_ROOT: Final = Path(__file__).parent.parent
_CORPUS: Final = _ROOT / "tests" / "corpus"
_HANG_S: Final = 240
_BATCH: Final = 100


def seeds(form: str) -> list[bytes]:
    """Return small whole files of a format, of several kinds."""
    if form in ("psd", *SHEETS):
        return [path.read_bytes() for path in sorted(_CORPUS.rglob(f"*.{form}"))]
    if form not in PICTURES:
        from tests.io.sets.mutants import originals

        with tempfile.TemporaryDirectory() as folder:
            return [originals(Path(folder), with_usd=form in USD)[f".{form}"]]
    chance = np.random.default_rng(1)
    rgba = np.repeat(chance.integers(0, 256, (9, 5, 4)).astype(np.uint8), 3, axis=1)
    image, opaque = Image.fromarray(rgba), Image.fromarray(rgba[..., :3])
    film: dict[str, Any] = {"save_all": True, "append_images": [image.rotate(180)], "duration": 90}
    match form:
        case "tga":
            return [_saved(each, "tga", **how) for each in (image, opaque, opaque.quantize(9)) for how in _PACKED] + [
                _targa_palette(rgba)
            ]
        case "tif":
            ways: list[dict[str, Any]] = [{"compression": each} for each in ("raw", "tiff_lzw", "tiff_adobe_deflate")]
            return [_saved(image, "tiff", **each) for each in ways] + [_saved(image, "tiff", **film)]
        case "exr":
            return [_exr(names, packing) for names in _LAYERS for packing in ("zip", "none", "piz", "dwaa")]
        case "webp":
            return [_saved(image, "webp", lossless=True), _saved(opaque, "webp"), _saved(image, "webp", **film)]
        case "png":
            profile = b"x\0\0" + zlib.compress(bytes(300))
            plain = _saved(image, "png")
            named = plain[:33] + _chunk(b"iCCP", profile) + _chunk(b"gAMA", bytes(4)) + plain[33:]
            return [plain, named, _saved(opaque.quantize(9), "png"), _saved(image, "png", **film)]
        case "jpg":
            inks = _saved(opaque.convert("CMYK"), "jpeg")
            return [_saved(opaque, "jpeg"), inks, _saved(opaque, "jpeg", progressive=True)]
        case "gif":
            return [_saved(opaque.quantize(9), "gif"), _saved(image, "gif", **film)]
        case _:
            return [_saved(opaque, "bmp"), _saved(opaque.quantize(9), "bmp"), _saved(image, "bmp")]


_PACKED: Final[tuple[dict[str, Any], ...]] = ({}, {"compression": "tga_rle"})
_LAYERS: Final = (("R", "G", "B", "A"), ("R", "G", "B", "A", "Z", "d.R", "d.G", "d.B"))


def _saved(image: Image.Image, kind: str, **how: Any) -> bytes:
    out = io.BytesIO()
    image.save(out, kind, **how)
    return out.getvalue()


def _targa_palette(rgba: Any) -> bytes:
    head = struct.pack("<BBBHHBHHHHBB", 0, 1, 1, 0, 9, 32, 0, 0, 5, 9, 8, 8)
    colours: bytes = rgba[:, 0].tobytes()
    return head + colours + bytes(index % 9 for index in range(45))


def _chunk(name: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))


def _exr(names: tuple[str, ...], packing: str) -> bytes:
    spec = oiio.ImageSpec(15, 9, len(names), oiio.HALF)
    spec.channelnames = names
    spec.attribute("compression", packing)
    spec.attribute("chromaticities", oiio.TypeDesc("float[8]"), (0.7, 0.3, 0.2, 0.7, 0.1, 0.05, 0.31, 0.33))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "a.exr"
        out = oiio.ImageOutput.create(str(path))
        assert out is not None
        out.open(str(path), spec)
        out.write_image(np.random.default_rng(2).random((9, 15, len(names))).astype(np.float16))
        out.close()
        return path.read_bytes()


def mutants(whole: bytes, chance: random.Random) -> Iterator[bytes]:
    """Yield damaged files without end: single bytes, numbers, parts left out or twice, and cuts; most near the head."""
    while True:
        data = bytearray(whole)
        for _ in range(chance.randint(1, 6)):
            reach = len(data) if chance.random() < 0.5 else min(len(data), 200)
            at = chance.randrange(max(reach, 1))
            match chance.randrange(6):
                case 0 | 1 | 2:
                    data[at : at + 1] = bytes([chance.choice([0, 1, 127, 128, 254, 255, chance.randrange(256)])])
                case 3:
                    data[at : at + 4] = struct.pack("<I", chance.choice([0, 1, 65535, 1 << 31, (1 << 32) - 1]))
                case 4:
                    del data[at : at + chance.randint(1, 8)]
                case _:
                    data[at:at] = data[at : at + chance.randint(1, 8)]
        yield _mended(bytes(data if chance.random() < 0.8 else data[: chance.randrange(len(data) or 1)]), chance)


def _mended(data: bytes, chance: random.Random) -> bytes:
    """Return a PNG with right checksums half of the time, so that what is behind them is reached."""
    if not data.startswith(b"\x89PNG") or chance.random() < 0.5:
        return data
    out, at = data[:8], 8
    while at + 8 <= len(data):
        length = int.from_bytes(data[at : at + 4])
        if at + 12 + length > len(data):
            return out + data[at:]
        out += _chunk(data[at + 4 : at + 8], data[at + 8 : at + 8 + length])
        at += 12 + length
    return out + data[at:]


def mutants_of(form: str, seed: int) -> list[Iterator[bytes]]:
    """Return damaged files of a format without end, a source for each seed; where numbers are words, those as well."""
    chance = random.Random(f"{form}{seed}")
    if form in PICTURES:
        return [mutants(each, chance) for each in seeds(form)]
    from tests.io.sets.mutants import mutants as text_mutants

    return [text_mutants(each, 1 << 30, chance.randrange(1 << 30)) for each in seeds(form)]


def _read_picture(path: Path, number: int) -> None:
    from kagezou.importing.file_pages import FILM_RATE, pages_of
    from kagezou.io.images.reading import probe, read_cel, read_matte

    probe(path)
    pages = pages_of(path, FILM_RATE)
    read_matte(path if pages is None else pages.cels.drawings[-1].source)
    read_cel(path, white_is_clear=bool(number % 2))


def _read_psd(path: Path, number: int) -> None:
    from kagezou.importing.inspection import inspected

    inspected(path)
    _read_picture(path, number)


def _read_set(path: Path, _number: int) -> None:
    from kagezou.io.sets.cameras import cameras_of, up_axis_of
    from kagezou.io.sets.mesh_cache import read_set

    up_axis_of(path)
    cameras_of(path, Fraction(24))
    read_set(path)


def _read_usd_here(path: Path, _number: int) -> None:
    from kagezou.errors import InputProblem
    from kagezou.io.sets.usd_child import contents_of
    from kagezou.message import Message

    with np.errstate(all="ignore"):
        found = contents_of(path, Fraction(24))
    if isinstance(found.triangles, Message):
        raise InputProblem(found.triangles)


def _read_sheets(path: Path, _number: int) -> None:
    from kagezou.io.sheets.reading import read_sheets

    read_sheets(path)


def _reader(form: str, *, apart: bool) -> Callable[[Path, int], None]:
    """Return what asks a file for all it may hold; USD as the program does where that is asked for."""
    if form in SHEETS:
        return _read_sheets
    if form == "psd":
        return _read_psd
    if form in PICTURES:
        return _read_picture
    return _read_usd_here if form in USD and not apart else _read_set


def results(form: str, numbers: range, seed: int, *, apart: bool = False) -> Iterator[str]:
    """Yield for files of a seed, by their numbers, whether each was read, refused by a sentence, or ended otherwise."""
    from kagezou.errors import InputProblem

    sources, read = mutants_of(form, seed), _reader(form, apart=apart)
    with tempfile.TemporaryDirectory() as folder:
        for number in range(numbers.stop):
            data = next(sources[number % len(sources)])
            if number not in numbers:
                continue
            path = Path(folder) / f"{number}.{form}"
            path.write_bytes(data)
            try:
                read(path, number)
                yield "read"
            except InputProblem as problem:
                yield "refused" if "\n" not in str(problem) else "refused by several lines"
            except Exception as error:  # what is looked for
                yield f"untyped {type(error).__name__}: {error}"[:200]
            path.unlink()


def outcomes(form: str, count: int, seed: int) -> Counter[str]:
    """Return how many files were read, refused by a sentence, or ended otherwise, in this process."""
    return Counter(results(form, range(count), seed))


def main(words: list[str]) -> int:
    """Run all formats, or those that are named, and print the counts."""
    sys.path.insert(0, str(_ROOT))
    if words[:1] == ["--child"]:
        form, numbers, seed = words[1], range(int(words[2]), int(words[3])), int(words[4])
        for each in results(form, numbers, seed, apart="--apart" in words):
            print(json.dumps(each), flush=True)
        return 0
    count, first = int(words[0]) if words else 2000, int(words[1]) if words[1:] else 1
    bad = 0
    for form in words[2:] or FORMATS:
        found: Counter[str] = Counter()
        for seed in range(first, first + -(-count // _BATCH)):
            found.update(_batch(form, seed))
        print(form, dict(found), flush=True)
        bad += sum(number for name, number in found.items() if name not in _SOUND)
    return min(bad, 1)


_ALONE: Final = "ended a process of its own alone"
_SOUND: Final = frozenset({"read", "refused", _ALONE})


def _batch(form: str, seed: int) -> Iterator[str]:
    """Yield how each file of a seed ended, one that takes its process along as well."""
    at = 0
    while at < _BATCH:
        came, ended = _of_child(form, seed, range(at, _BATCH))
        yield from came
        at += len(came)
        if at < _BATCH:
            yield from _apart(form, seed, at) if form in USD else (f"{ended} (seed {seed}, file {at})",)
            at += 1


def _apart(form: str, seed: int, number: int) -> tuple[str, ...]:
    """Return how a file ended that took the process of many along, read as the program reads it."""
    came, ended = _of_child(form, seed, range(number, number + 1), "--apart")
    if came in (["read"], ["refused"]):
        return (_ALONE,)
    return tuple(came) or (f"{ended} (seed {seed}, file {number})",)


def _of_child(form: str, seed: int, numbers: range, *how: str) -> tuple[list[str], str]:
    """Return how files ended that a process read, and how the process itself did."""
    command = [sys.executable, __file__, "--child", form, str(numbers.start), str(numbers.stop), str(seed), *how]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        try:
            said, _ = process.communicate(timeout=_HANG_S)
            ended = f"crash {process.returncode}"
        except subprocess.TimeoutExpired:
            process.kill()
            said, _ = process.communicate()
            ended = "hang"
    return [json.loads(line) for line in said.splitlines()], ended


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
