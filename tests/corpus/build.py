"""Makes the files of the corpus anew: ``python -m tests.corpus.build``."""

import json
import struct
from collections.abc import Callable, Sequence
from math import erf, sqrt
from pathlib import Path
from typing import Any, Final

import numpy as np
import OpenImageIO as oiio  # noqa: N813  # the name its own manual uses
from numpy.typing import NDArray
from PIL import Image
from psd_tools import PSDImage
from psd_tools.constants import BlendMode, Tag

from tests.psd_files import Cut, Folder, Leaf, block, with_picture, write_psd

HERE: Final = Path(__file__).parent
SIZE: Final = (16, 12)
ACESCG: Final = (0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767)


def cel(number: int = 1) -> NDArray[np.uint8]:
    """A block that stands on the lower third and walks to the right, straight, (12, 16, 4)."""
    pixels = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    pixels[3:10, 2 + number : 8 + number] = (200, 120, 40, 255)
    return pixels


def png(path: Path, pixels: NDArray[Any], **options: Any) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(pixels).save(path, "PNG", **options)


def sequence(folder: str, names: Sequence[str]) -> None:
    for number, name in enumerate(names, 1):
        png(HERE / folder / f"{name}.png", cel(number))


# ---- names


def names() -> None:
    sequence("names/negative", ["img_-0003", "img_-0002", "img_-0001"])
    sequence("names/word_behind", ["walk_0001_final", "walk_0002_final", "walk_0003_final"])
    sequence("names/version_behind", ["walk_0001_v02", "walk_0002_v02", "walk_0003_v02"])
    sequence("names/eight_digits", ["A00000001", "A00000002", "A00000003"])
    sequence("names/copies_of_windows", ["A (1)", "A (2)", "A (3)"])
    sequence("names/retake", ["A0001", "A0002", "A0002_R1", "A0003"])
    sequence("names/inserts", ["A0001", "A0001a", "A0002"])
    sequence("names/full_width", ["Ａ０００１", "Ａ０００２"])
    sequence("names/two_characters", ["A0001", "A0002", "B0001", "B0002"])
    sequence("names/from_zero", ["walk_0", "walk_1", "walk_2"])


# ---- pictures


def exr(path: str, pixels: NDArray[np.float32], channels: Sequence[str], **attributes: Any) -> None:
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], oiio.HALF)
    spec.channelnames = tuple(channels)
    spec.attribute("DateTime", "")
    for name, value in attributes.items():
        if isinstance(value, tuple):
            spec.attribute(name, oiio.TypeDesc(f"float[{len(value)}]"), value)
        else:
            spec.attribute(name, value)
    (HERE / path).parent.mkdir(parents=True, exist_ok=True)
    out: Any = oiio.ImageOutput.create(str(HERE / path))
    assert out.open(str(HERE / path), spec), out.geterror()
    assert out.write_image(np.ascontiguousarray(pixels)), out.geterror()
    out.close()


def light(number: int = 1) -> NDArray[np.float32]:
    """The same block in linear light, multiplied by its alpha."""
    made: NDArray[np.float32] = cel(number).astype(np.float32) / np.float32(255)
    made[..., :3] = made[..., :3] ** np.float32(2.2) * made[..., 3:]
    return made


def pictures() -> None:
    plain = light()
    exr("pictures/beauty_and_depth.exr", np.concatenate([plain, plain[..., :1] * 9], 2), ["R", "G", "B", "A", "Z"])
    layers = np.concatenate([plain * 0, plain], 2)
    exr("pictures/layers.exr", layers, [f"{layer}.{c}" for layer in ("normal", "beauty") for c in "RGBA"])
    exr("pictures/acescg.exr", plain, ["R", "G", "B", "A"], chromaticities=ACESCG)
    glow = plain.copy()
    glow[..., 3] = 0
    exr("pictures/no_cover.exr", glow, ["R", "G", "B", "A"])
    first = Image.fromarray(cel())
    more = [Image.fromarray(cel(number)) for number in (2, 3)]
    first.save(HERE / "pictures/film.png", save_all=True, append_images=more, duration=125)
    first.save(HERE / "pictures/film.webp", save_all=True, append_images=more, duration=125, lossless=True)
    first.save(HERE / "pictures/pages.tif", save_all=True, append_images=more)
    first.quantize(8).save(HERE / "pictures/palette.png", transparency=0)
    (HERE / "pictures/unspecified_extra.tif").write_bytes(tiff(cel(), extra=0))
    (HERE / "pictures/palette.tga").write_bytes(palette_tga())
    (HERE / "pictures/gray_alpha.tga").write_bytes(gray_tga())
    whole = (HERE / "names/from_zero/walk_0.png").read_bytes()
    (HERE / "pictures/half.png").write_bytes(whole[: len(whole) // 2])
    png(HERE / "pictures/sixteen_bits.png", (cel()[..., 3].astype(np.uint16) * 257))
    png(HERE / "pictures/opaque.png", np.full((SIZE[1], SIZE[0], 4), 255, np.uint8))


def tiff(pixels: NDArray[np.uint8], extra: int) -> bytes:
    """An uncompressed RGB picture with a fourth channel of the given meaning."""
    height, width = pixels.shape[:2]
    data = pixels.tobytes()
    bits = 8 + len(data)
    entries = [
        (256, 3, 1, width), (257, 3, 1, height), (258, 3, 4, bits), (259, 3, 1, 1), (262, 3, 1, 2), (273, 4, 1, 8),
        (277, 3, 1, 4), (278, 3, 1, height), (279, 4, 1, len(data)), (338, 3, 1, extra),
    ]  # fmt: skip
    table = struct.pack("<H", len(entries)) + b"".join(struct.pack("<HHII", *entry) for entry in entries)
    return b"II*\0" + struct.pack("<I", bits + 8) + data + struct.pack("<4H", 8, 8, 8, 8) + table + struct.pack("<I", 0)


def palette_tga() -> bytes:
    """Indices into a palette whose first colour is clear, from the top left."""
    head = struct.pack("<BBBHHBHHHHBB", 0, 1, 1, 0, 2, 32, 0, 0, *SIZE, 8, 0x20)
    colours = bytes((0, 0, 0, 0)) + bytes((40, 120, 200, 255))
    return head + colours + (cel()[..., 3] > 0).astype(np.uint8).tobytes()


def gray_tga() -> bytes:
    """Gray and alpha in 16 bits, from the bottom left."""
    head = struct.pack("<BBBHHBHHHHBB", 0, 0, 3, 0, 0, 0, 0, 0, *SIZE, 16, 0x08)
    pixels = np.dstack([cel()[..., 0], cel()[..., 3]])[::-1]
    return head + pixels.astype(np.uint8).tobytes()


# ---- PSD files


def psd_files() -> None:
    whole = (64, 48)
    body, shade = Leaf("body", block(20, 30), (10, 10)), Leaf("in", block(*whole, (10, 20, 30, 255)))
    two = [Leaf("1", block(20, 20), (4, 20)), Leaf("2", block(20, 20), (9, 20), is_visible=False)]
    write_psd(HERE / "psd/cels.psd", [Folder("A", two)])
    clipped = np.zeros((48, 64, 4), np.uint8)
    clipped[10:40, 10:30] = (10, 20, 30, 255)
    layers: list[Leaf | Folder] = [body, Folder("shade", [shade], is_clipped=True)]
    with_picture(write_psd(HERE / "psd/clipped_group.psd", layers), clipped)
    path = Cut(path=(32, -200, 300, 300), path_density=204, path_feather=1.5)
    cut = block(*whole)
    soft = [0.5 * (1 + erf((x + 0.5 - 32) / (1.5 * sqrt(2)))) for x in range(64)]
    cut[..., 3] = np.rint(255 * (0.2 + 0.8 * np.array(soft)))
    with_picture(write_psd(HERE / "psd/path.psd", [Leaf("sheet", block(*whole), cut=path)]), cut)
    write_psd(HERE / "psd/blended.psd", [Folder("A", two, opacity=128, blend=BlendMode.MULTIPLY)])
    adjusted = write_psd(HERE / "psd/adjusted.psd", [Folder("A", two), body])
    image = PSDImage.open(adjusted)
    extra = image.create_pixel_layer(Image.new("RGBA", (1, 1)), name="x")
    extra.name = "Invert 1"
    extra.tagged_blocks.set_data(Tag.INVERT)
    image.save(adjusted)
    with_picture(adjusted)


# ---- sets

_SQUARE: Final = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]
_GATE: Final = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 3 2 0\nv 3 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nf 1 2 3 4 5 6 7 8\n"


def sets() -> None:
    (HERE / "sets").mkdir(exist_ok=True)
    (HERE / "sets/gate.obj").write_text(_GATE)
    (HERE / "sets/utf16.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 # a face\n", encoding="utf-16")
    (HERE / "sets/bom.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 \\\n 2/2 3/3\n", encoding="utf-8-sig")
    (HERE / "sets/solid_in_binary.stl").write_bytes(
        b"solid of bytes".ljust(80) + struct.pack("<I", 1) + struct.pack("<12fH", *([0] * 5), 1, 1, 0, 0, 0, 1, 0, 0)
    )
    square = np.array(_SQUARE, "<f4")
    plain = ("positions", square.tobytes(), {"componentType": 5126, "count": 4, "type": "VEC3"})
    corners = np.array([0, 1, 2, 0, 2, 3], "<u2")
    gltf("sets/plain.gltf", [plain], corners)
    quantized = np.zeros((4, 4), "<i2")
    quantized[:, :3] = square / 2 * 32767
    gltf(
        "sets/quantized.gltf",
        [("positions", quantized.tobytes(), {"componentType": 5122, "count": 4, "type": "VEC3", "normalized": True})],
        corners,
        stride=8,
        extensionsUsed=["KHR_mesh_quantization"],
        extensionsRequired=["KHR_mesh_quantization"],
        node={"scale": [2, 2, 2]},
    )
    gltf("sets/unknown_extension.gltf", [plain], corners, extensionsRequired=["EXT_that_nobody_knows"])
    gltf("sets/hidden.gltf", [plain], corners, twice={"extensions": {"KHR_node_visibility": {"visible": False}}},
         extensionsUsed=["KHR_node_visibility"])  # fmt: skip
    (HERE / "sets/parts.usda").write_text(_USDA)


_USDA: Final = """#usda 1.0
(
    upAxis = "Y"
)

def Xform "set"
{
    def Cube "solid"
    {
        double size = 2
    }

    def Mesh "guide"
    {
        uniform token purpose = "guide"
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (90, 0, 0), (0, 90, 0)]
    }
}
"""


def gltf(
    path: str,
    accessors: Sequence[tuple[str, bytes, dict[str, Any]]],
    corners: NDArray[np.uint16],
    stride: int | None = None,
    node: dict[str, Any] | None = None,
    twice: dict[str, Any] | None = None,
    **extra: Any,
) -> None:
    """Write a mesh of one primitive, its bytes within the file; ``twice`` adds a second node of it."""
    import base64

    views: list[dict[str, Any]] = []
    data = b""
    for _, numbers, _ in accessors:
        view = {"buffer": 0, "byteOffset": len(data), "byteLength": len(numbers)}
        views.append(view if stride is None else {**view, "byteStride": stride})
        data += numbers
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": corners.nbytes})
    data += corners.tobytes()
    nodes: list[dict[str, Any]] = [{"mesh": 0, **(node or {})}]
    if twice is not None:
        nodes.append({"mesh": 0, "translation": [9, 0, 0], **twice})
    tree = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": len(accessors)}]}],
        "accessors": [
            *({"bufferView": index, **about} for index, (_, _, about) in enumerate(accessors)),
            {"bufferView": len(accessors), "componentType": 5123, "count": len(corners), "type": "SCALAR"},
        ],
        "bufferViews": views,
        "buffers": [
            {
                "byteLength": len(data),
                "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
            }
        ],
        **extra,
    }
    (HERE / path).write_text(json.dumps(tree, indent=1))


# ---- timesheets


def _xdts(tables: Sequence[dict[str, Any]]) -> str:
    return json.dumps({"header": {"cut": "12", "scene": "3"}, "timeTables": tables, "version": 5}, ensure_ascii=False)


def _table(name: str, cels: Sequence[tuple[int, str]], *more: dict[str, Any]) -> dict[str, Any]:
    frames = [{"frame": frame, "data": [{"id": 0, "values": [value]}]} for frame, value in cels]
    return {
        "name": name,
        "duration": 12,
        "timeTableHeaders": [{"fieldId": 0, "names": ["A"]}],
        "fields": [{"fieldId": 0, "tracks": [{"trackNo": 0, "frames": frames}]}, *more],
    }


def sheets() -> None:
    sequence("sheets/A", ["A0001", "A0002"])
    first = "exchangeDigitalTimeSheet Save Data"
    plain = _table("cut", [(0, "1"), (6, "2")])
    (HERE / "sheets/plain.xdts").write_text(f"{first}\n{_xdts([plain])}\n", encoding="utf-8")
    (HERE / "sheets/one_line.xdts").write_text(first + _xdts([plain]), encoding="utf-8")
    (HERE / "sheets/bom.xdts").write_text(f"{first}\r\n{_xdts([plain])}\r\n", encoding="utf-8-sig")
    two = [plain, _table("retake", [(0, "2")])]
    (HERE / "sheets/two_tables.xdts").write_text(f"{first}\n{_xdts(two)}\n", encoding="utf-8")
    words = {"fieldId": 3, "tracks": [{"trackNo": 0, "frames": [
        {"frame": 0, "data": [{"id": 0, "values": ["Mari", "Good morning"]}]}]}]}  # fmt: skip
    spoken = _table("cut", [(0, "1"), (3, "SYMBOL_TICK_1"), (6, "2")], words)
    (HERE / "sheets/spoken.xdts").write_text(f"{first}\n{_xdts([spoken])}\n", encoding="utf-8")
    cels = np.array([1, 1, 1, 2, 2, 0], "<u2").tobytes()
    (HERE / "sheets/old.sts").write_bytes(b"\x11ShiraheiTimeSheet" + bytes((1, 6, 0, 0, 0)) + cels + b"\x01A")


PARTS: Final[Sequence[Callable[[], None]]] = (names, pictures, psd_files, sets, sheets)

if __name__ == "__main__":
    for part in PARTS:
        part()
