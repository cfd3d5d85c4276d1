"""Scenes for OpenToonz: levels and columns, and effects that lay them on each other with their opacity.

Everything is written as OpenToonz's own streams are read (`tstream.cpp`, `toonzscene.cpp`, `txshlevelcolumn.cpp`,
`tfx.cpp`, `ino_common.cpp`): tags within tags, a text in quotes where it is more than letters, objects by numbers.
"""

from collections.abc import Iterable, Iterator
from typing import Final

from kagezou.export.exchange.stack import SceneTarget, SceneText, Stack, StackLayer, held
from kagezou.message import Message

_VERSION: Final = "71.1"
_DPI: Final = 120
"""Pixels of a picture for an inch of the camera: any number that both have."""

_STEP: Final = 140
_ROW: Final = 90


def opentoonz_scene(stack: Stack) -> SceneText:
    """Return the scene of a cut; it finds the pictures beside itself."""
    parts = [
        _tag("generator", "Kagezou"),
        _tag("properties", *_properties(stack)),
        _tag("levelSet", *_levels(stack)),
        _tag("xsheet", *_xsheet(stack)),
    ]
    head = f'version="{_VERSION}" framecount="{stack.length_frames}"'
    return SceneText("\n".join(_tagged("tnz", head, parts)) + "\n", tuple(_notes(stack)))


def _properties(stack: Stack) -> Iterator[list[str]]:
    yield _tag("cameras", _tag("camera", *_camera(stack)))
    rate = _tag("fps", f"{float(stack.frame_rate):.9g}")
    # In 16 bit nothing is rounded to be seen while layers are laid on each other.
    main = [_tag("range", "0 -1"), _tag("step", "1"), _tag("shrink", "1"), rate, _tag("bpp", "64")]
    outputs = [_tagged("output", 'name="main"', main), _tagged("output", 'name="preview"', main)]
    yield _tag("outputs", *outputs)


def _camera(stack: Stack) -> list[list[str]]:
    return [
        _tag("cameraSize", f"{stack.width_px / _DPI:.9g} {stack.height_px / _DPI:.9g}"),
        _tag("cameraRes", f"{stack.width_px} {stack.height_px}"),
        _tag("cameraXPrevalence", "1"),
        _tag("interestRect", "0 0 -1 -1"),
    ]


def _levels(stack: Stack) -> Iterator[list[str]]:
    """Yield the levels, and the folder of the cast that they are in."""
    places = range(1, len(stack.layers) + 1)
    levels = [
        _tagged("level", f"id='{place}'", [[_text(layer.label)], *_level(stack, layer)])
        for place, layer in zip(places, stack.layers, strict=True)
    ]
    yield _tag("levels", *levels)
    yield _tagged("folder", 'name="Cast" type="default"', [_tag("levels", *(_known("level", each) for each in places))])


def _level(stack: Stack, layer: StackLayer) -> list[list[str]]:
    # The two dots stand about the number of the frame.
    path = f"$scenefolder/{stack.pattern(layer.label, '')}"
    return [[f'<info dpix="{_DPI}" dpiy="{_DPI}"/>'], _tag("path", _text(path))]


def _xsheet(stack: Stack) -> Iterator[list[str]]:
    numbers = _Numbers(len(stack.layers))
    columns = [
        _tagged("levelColumn", f"id='{numbers.column(place)}'", _column(layer, place, numbers))
        for place, layer in enumerate(stack.layers)
    ]
    yield _tag("columns", *columns)
    yield _tag("pegbars", *_pegbars(stack))
    yield _tag("fxnodes", *_effects(stack, numbers))


class _Numbers:
    """By which objects are known; those of levels come first."""

    def __init__(self, count: int) -> None:
        self._count = count

    def column(self, place: int) -> int:
        """Return that of a column."""
        return self._count + 1 + place

    def column_effect(self, place: int) -> int:
        """Return that of what a column gives to effects."""
        return 2 * self._count + 1 + place

    def effect(self, place: int) -> int:
        """Return that of the effect that lays a column."""
        return 3 * self._count + 1 + place

    @property
    def last(self) -> int:
        """The highest of all of these."""
        return 4 * self._count


def _column(layer: StackLayer, place: int, numbers: _Numbers) -> list[list[str]]:
    source = [_tag("dagNodePos", f"{place * _STEP} {place * _ROW}"), _tag("numberId", "1"), _tag("opened", "0")]
    effect = _tagged("Toonz_columnFx", f"id='{numbers.column_effect(place)}'", source)
    return [_tag("status", "0"), _tag("cells", *_cells(layer, place)), _tag("fx", effect)]


def _cells(layer: StackLayer, place: int) -> Iterator[list[str]]:
    """Yield the exposures: first row, rows, level, number of the picture, and what that grows by in each row."""
    shown = list(held(layer.pictures, 0))
    ends = [*(at for at, _ in shown[1:]), len(layer.pictures)]
    for (start, picture), end in zip(shown, ends, strict=True):
        if picture:
            yield _tag("cell", f"{start} {end - start} <level id='{place + 1}'/>{picture:04d} 0")


def _pegbars(stack: Stack) -> Iterator[list[str]]:
    camera = [*_peg("None"), _tag("nodePos", "0 0"), _tag("camera", *_camera(stack))]
    yield _tagged("pegbar", 'id="Camera1" activeboth="yes"', camera)
    yield _tagged("pegbar", 'id="Table"', [*_peg("None"), _tag("nodePos", "0 0")])
    for place, layer in enumerate(stack.layers, start=1):
        named = [*_peg("Table"), _tag("name", _text(layer.name)), _tag("nodePos", f"{place * _STEP} 0")]
        yield _tagged("pegbar", f'id="Col{place}"', named)


def _peg(parent: str) -> list[list[str]]:
    hold = f'id="{parent}" handle="B" parentHandle="B"'
    return [_tagged("parent", hold, []), _tag("center", "0 0 0 0"), _tag("status", "0")]


def _effects(stack: Stack, numbers: _Numbers) -> Iterator[list[str]]:
    """Yield what lays each column on the sum of those below it, and what goes to the camera."""
    inside: list[list[str]] = []
    last: list[str] = []
    for place, layer in enumerate(stack.layers):
        kind = "STD_inoMultiplyFx" if layer.multiply else "STD_inoOverFx"
        upper = _known("Toonz_columnFx", numbers.column_effect(place))
        ports = [_tag("Fore", upper), *([_tag("Back", last)] if last else [])]
        inside.append(_tag("fxnode", _tagged(kind, f"id='{numbers.effect(place)}'", _laying(layer, place, ports))))
        last = _known(kind, numbers.effect(place))
    yield _tag("internal", *inside)
    yield _tag("terminal", _tag("fxnode", last))
    xsheet, output = numbers.last + 1, numbers.last + 2
    beside = _tag("dagNodePos", f"{(len(stack.layers) + 1) * _STEP} 0")
    yield _tag("xsheet", _tagged("Toonz_xsheetFx", f"id='{xsheet}'", [beside]))
    source = _tag("ports", _tag("source", _known("Toonz_xsheetFx", xsheet)))
    yield _tag("output", _tagged("Toonz_outputFx", f"id='{output}'", [source, beside]))


def _laying(layer: StackLayer, place: int, ports: list[list[str]]) -> list[list[str]]:
    keys = list(held(layer.opacities, 0))
    curve = [_tag("C", f"{frame} {opacity:.9g}") for frame, opacity in keys]
    opacity = [_tag("default", f"{keys[0][1]:.9g}"), *([_tag("keyframes", *curve)] if len(keys) > 1 else [])]
    # Without it a layer shows where nothing is under it, too.
    unclipped = _tag("clipping_mask", "0 0")
    name = f"{'inoMultiplyFx' if layer.multiply else 'inoOverFx'}{place + 1}"
    return [
        _tag("params", _tag("opacity", *opacity), unclipped),
        _tag("ports", *ports),
        _tag("dagNodePos", f"{(place + 1) * _STEP} {place * _ROW}"),
        _tag("numberId", f"{place + 1}"),
        _tag("name", _text(layer.name)),
        _tag("fxId", name),
        _tag("opened", "0"),
        _tag("fxVersion", "2"),
    ]


def _notes(stack: Stack) -> Iterator[Message]:
    if stack.first_frame != 1:
        yield Message(
            "frames are counted from 1 in OpenToonz: its frame 1 is frame {first} here", first=stack.first_frame
        )
    if not stack.is_filled and sum(layer.multiply for layer in stack.layers) > 1:
        yield Message(
            "nothing fills the canvas: where half-clear shadows lie on each other there, OpenToonz mixes them in its "
            "own way; put something opaque under them"
        )


def _tag(name: str, *inside: str | list[str]) -> list[str]:
    """Return the lines of a tag without attributes; a text alone stands on its line."""
    if len(inside) == 1 and isinstance(inside[0], str):
        return [f"<{name}>{inside[0]} </{name}>"]
    return _tagged(name, "", [[each] if isinstance(each, str) else each for each in inside])


def _tagged(name: str, attributes: str, inside: Iterable[list[str]]) -> list[str]:
    head = f"{name} {attributes}" if attributes else name
    return [f"<{head}>", *(f"  {line}" for lines in inside for line in lines), f"</{name}>"]


def _known(kind: str, number: int) -> list[str]:
    """Return what stands for an object that was written before."""
    return [f"<{kind} id='{number}'/>"]


def _text(words: str) -> str:
    """Return a text in quotes; signs that would end it stand behind a backslash, others that make tags are gone."""
    plain = words.translate(str.maketrans("<>&\n\r\t", "______"))
    return '"' + plain.replace("\\", r"\\").replace('"', r"\"") + '"'


OPENTOONZ: Final = SceneTarget(".tnz", "opentoonz_layers", opentoonz_scene, separator=".")
