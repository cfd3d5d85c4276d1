"""``kagezou bench``: how fast this machine draws and exports."""

import tempfile
from argparse import Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, size, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, ProgressLine, give, give_json
from kagezou.errors import UsageProblem
from kagezou.io.files.processors import processors
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.cli.bench.operations import Measured
    from kagezou.cli.bench.peers import Compared
    from kagezou.cli.bench.scale import Grown
    from kagezou.cli.bench.throughput import Throughput
    from kagezou.document.model import Document
    from kagezou.io.images.cel_cache import CelCache

DESCRIPTION = """\
Measure each operation from the changed document to the finished picture, beside one plain copy of a whole picture,
and an export beside the same files only read and written. Uses the demo's drawings unless others are given."""
EXAMPLES = """\
  kagezou bench
  kagezou bench --json --size 1920x1080
  kagezou bench --input drawings/hero
  kagezou bench --peers        beside other programs that do the same
  kagezou bench --window
  kagezou bench --scale        2,000 frames, 60 layers, 4K: takes minutes
  kagezou bench --profile export.svg        where the time of an export goes
"""
DEFAULT_SIZE = (1000, 1000)


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("--input", type=Path, metavar="DIR", help="a folder of numbered drawings")
    parser.add_argument(
        "--size", type=size, metavar="WxH", help="the canvas in px (1000x1000, or that of the drawings)"
    )
    parser.add_argument("--workers", type=whole_number, metavar="N", help="threads of the export")
    parser.add_argument(
        "--peers",
        action="store_true",
        help="also beside ffmpeg and OpenCV, where they are installed: PNG drawings only",
    )
    parser.add_argument(
        "--window", action="store_true", help="measure the window instead, by events of the X server: drags and playing"
    )
    parser.add_argument(
        "--scale",
        action="store_true",
        help="measure instead how time and memory grow with frames, layers, pixels, cuts and workers on one folder",
    )
    parser.add_argument(
        "--profile",
        type=Path,
        metavar="FILE.svg",
        help="write instead a flame graph of an export, all its processes and threads; needs py-spy",
    )
    parser.add_argument("--json", action="store_true", help="print one object")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Measure and report."""
    if options.window:
        return _measure_window(options, entry_points)
    if options.scale:
        return _measure_scale(options)
    if options.profile is not None:
        return _profile(options)
    return _measure(options, entry_points)


def _measure(options: Namespace, entry_points: EntryPoints) -> int:
    """Measure each operation and an export."""
    from kagezou.cli.bench import operations, throughput
    from kagezou.cli.bench.hills import write_hills
    from kagezou.io.images.cel_cache import CelCache
    from kagezou.render.renderer import Renderer

    workers = options.workers or processors()
    with tempfile.TemporaryDirectory(prefix="kagezou-bench-") as folder:
        document = _document(options, Path(folder), workers)
        cels = CelCache()
        _read_all(document, cels)
        with entry_points.open_context() as context:
            renderer = Renderer(cels)
            name = context.info.renderer
            drawn = operations.measured(document, renderer, write_hills(Path(folder, "hills.ply")))
            renderer.close()
        cels.clear()
        one = (document.layers[0].name,)
        export = throughput.measured(document, one, Path(folder, "one"), workers, entry_points.open_context)
        pair = _pair(options, Path(folder), workers)
        both = tuple(layer.name for layer in pair.layers)
        export_two = throughput.measured(pair, both, Path(folder, "two"), workers, entry_points.open_context)
        peers = _compared(document, Path(folder)) if options.peers else None
    size_px = (document.canvas.width_px, document.canvas.height_px)
    if options.json:
        rates: dict[str, Json] = {
            "export": _rates(export),
            "export_two_layers": {"size": [pair.canvas.width_px, pair.canvas.height_px], **_rates(export_two)},
        }
        if peers is not None:
            rates |= _peers_report(*peers)
        give_json({"gl_renderer": name, "size": [*size_px], **_report(drawn), **rates, "workers": workers})
        return 0
    _give_drawn(f"{name}, {size_px[0]} x {size_px[1]} px", drawn)
    wide_px = f"{pair.canvas.width_px} x {pair.canvas.height_px} px"
    _give_rates({"export": export, f"export of two layers of {wide_px}": export_two})
    _give_peers(*(peers or ((), ())))
    return 0


def _read_all(document: "Document", cels: "CelCache") -> None:
    for drawing in document.layers[0].cels.drawings:
        cels.cel(drawing.source)


def _give_rates(exports: "dict[str, Throughput]") -> None:
    for words, rate in exports.items():
        give(f"{words}: {rate.fps:.1f} frames/s; only reading and writing {rate.floor_fps:.1f}: {rate.of_floor:.0%}")


def _measure_window(options: Namespace, entry_points: EntryPoints) -> int:
    """Measure the window and report."""
    from kagezou.cli.bench.window import documents, lines, report

    if entry_points.measure_window is None:
        raise UsageProblem(Message("there is no display, so the window cannot be measured"))
    with tempfile.TemporaryDirectory(prefix="kagezou-bench-") as folder:
        device, answers = entry_points.measure_window(
            *documents(Path(folder, "drawings"), options.workers or processors())
        )
    if options.json:
        give_json({"gl_renderer": device, "window": report(answers)})
        return 0
    for line in (device, *lines(answers)):
        give(line)
    return 0


def _measure_scale(options: Namespace) -> int:
    """Measure how an export grows and report."""
    from kagezou.cli.bench.scale import grown

    measured: list[Json] = []
    with tempfile.TemporaryDirectory(prefix="kagezou-bench-") as folder, ProgressLine("measuring", unit=None) as line:
        drawings = _drawings(options, Path(folder), options.workers or processors())
        for each in grown(drawings, Path(folder), line.update):
            line.wipe()
            measured.append(_growth(each))
            if not options.json:
                _give_growth(each)
    if options.json:
        give_json({"scale": measured})
    return 0


def _growth(each: "Grown") -> Json:
    rows: list[Json] = [
        {"size": size, "seconds": round(took.wall_s, 3), "cpu": round(took.cpu_s, 3), "peak_bytes": took.peak_bytes}
        for size, took in zip(each.sizes, each.took, strict=True)
    ]
    return {"name": each.name, "rows": rows, "times": round(each.times, 3), "memory": round(each.memory, 3)}


def _give_growth(each: "Grown") -> None:
    for count, took in zip(each.sizes, each.took, strict=True):
        memory = f", {took.peak_bytes >> 20} MB" if took.peak_bytes else ""
        give(f"{count:>6} {each.name:<8} {took.wall_s:8.2f} s, {took.cpu_s:.2f} s of processors{memory}")
    words = f"{each.sizes[-1] / each.sizes[0]:g} times the {each.name}: {each.times:.2f} times the time"
    give(f"{words}, {each.memory:.2f} times the memory")


def _profile(options: Namespace) -> int:
    """Write where the time of an export goes."""
    from kagezou.cli.bench.flame_graph import write_flame_graph

    with tempfile.TemporaryDirectory(prefix="kagezou-bench-") as folder:
        write_flame_graph(_document(options, Path(folder), options.workers or processors()), options.profile)
    give(str(options.profile))
    return 0


def _compared(document: "Document", folder: Path) -> "tuple[tuple[Compared, ...], tuple[str, ...]]":
    """Compare with other programs, on the drawings of the first layer."""
    from kagezou.cli.bench.peers import compared
    from kagezou.picture_source import file_of

    drawings = file_of(document.layers[0].cels.drawings[0].source).parent
    (folder / "peers").mkdir()
    return compared(drawings, folder / "peers")


def _peers_report(peers: "tuple[Compared, ...]", missing: tuple[str, ...]) -> dict[str, Json]:
    ratios: list[Json] = [
        {"name": each.name, "wall": round(each.wall, 3), "cpu": None if each.cpu is None else round(each.cpu, 3)}
        for each in peers
    ]
    return {"peers": ratios, "peers_missing": [*missing]}


def _give_peers(peers: "tuple[Compared, ...]", missing: tuple[str, ...]) -> None:
    for each in peers:
        cpu = "" if each.cpu is None else f", {each.cpu:.2f} of its processor time"
        give(f"beside {each.name}: {each.wall:.2f} of its time{cpu} (whole processes, medians of pairs)")
    for name in missing:
        give(f"beside {name}: it is not installed")


def _give_drawn(where: str, drawn: "Measured") -> None:
    give(where)
    give(f"one copy of a whole picture: {drawn.copy_ms:.2f} ms")
    for each in drawn.operations:
        give(f"  {each.name:<16} {each.median_ms:7.2f} ms {each.fps:8.0f} fps {each.ratio:6.1f} copies")


def _report(drawn: "Measured") -> dict[str, Json]:
    operations: list[Json] = [
        {
            "name": each.name,
            "median_ms": round(each.median_ms, 4),
            "fps": round(each.fps, 1),
            "ratio": round(each.ratio, 2),
        }
        for each in drawn.operations
    ]
    return {"copy_ms": round(drawn.copy_ms, 4), "operations": operations}


def _rates(export: "Throughput") -> dict[str, Json]:
    return {
        "fps": round(export.fps, 2),
        "floor_fps": round(export.floor_fps, 2),
        "of_floor": round(export.of_floor, 3),
    }


def _document(options: Namespace, folder: Path, workers: int) -> "Document":
    """Return the document to measure with: one layer of the drawings given, or of the demo's."""
    from kagezou.importing.staging import CharacterSource, new_document

    canvas = options.size or (DEFAULT_SIZE if options.input is None else None)
    return new_document([CharacterSource("Character", _drawings(options, folder, workers))], size=canvas).document


def _drawings(options: Namespace, folder: Path, workers: int) -> Path:
    """Return the folder of the drawings given, or of the demo's, which are made in a folder."""
    from kagezou.cli.demo.stage import make_drawings

    if options.input is not None:
        return Path(options.input)
    with ProgressLine("drawing") as line:
        make_drawings(folder / "drawings", workers, line.update)
    return folder / "drawings"


def _pair(options: Namespace, folder: Path, workers: int) -> "Document":
    """Return the document of two layers: the drawings given twice, or the demo's child beside another."""
    from kagezou.cli.demo.stage import PAIR_SIZE_PX, make_pair
    from kagezou.importing.staging import CharacterSource, new_document

    sources, canvas = (options.input, options.input), options.size
    if options.input is None:
        canvas = PAIR_SIZE_PX
        with ProgressLine("drawing") as line:
            sources = make_pair(folder / "pair", workers, line.update)
    characters = [CharacterSource(name, source) for name, source in zip(("Left", "Right"), sources, strict=True)]
    return new_document(characters, size=canvas).document
