"""The description of the project format, made from the tables that the reader obeys.

``python -m kagezou.io.project.format`` writes ``FORMAT.md`` beside this module; a test compares the two.
"""

from fractions import Fraction
from pathlib import Path
from types import MappingProxyType
from typing import Final

from kagezou.animation.ease import EASY
from kagezou.animation.track import Interpolation, Key, Track
from kagezou.document.edits import still
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure, Layer, Marker, Piece
from kagezou.document.note import Note, NoteAnswer
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER, OF_PIECE
from kagezou.document.property import AnyProperty, Kind, Usual
from kagezou.geometry.box import Box
from kagezou.io.files.json_text import formatted
from kagezou.io.project import fields as fields
from kagezou.io.project.versions import BROUGHT
from kagezou.io.project.writing import tree_of

DESCRIPTION: Final = Path(__file__).with_name("FORMAT.md")

_HEAD: Final = """\
# The project file (.kage)

Made by `python -m kagezou.io.project.format` from the tables that the reader obeys; do not edit.

A project is one JSON object as UTF-8 text (a byte order mark is allowed), at most 32 MB and 2,000,000 values. It holds
no pictures and no code. Reading is strict: a key that is not listed here, a key that stands twice, a value of another
kind, NaN, infinity or a number beyond its range is refused with the place of the mistake, such as
`$.layers[2].tracks['shadow.opacity'].keys[0].frame`.

Lengths are canvas pixels (origin top left, x right, y down, z toward the viewer), angles degrees, times frames counted
from 1. A **path** has forward slashes and starts at the project's folder (`../` may lead out of it), or is absolute
where the picture lies on another drive. It never names a network share or a device. A property that is missing has its
default; a **track** is either a value (constant over the cut) or an object with keys.
"""


_RULE: Final = """\
The version rises with a release whose files an older release would refuse or read wrongly: one that adds a property, a
key or a choice, or changes what one means. It rises at most once a release. A program reads every version up to its own
and leads older files over when it saves; of a newer file it says which Kagezou is needed.

"""


def description() -> str:
    """Return the whole text of ``FORMAT.md``."""
    parts = [_HEAD, "\n## Versions\n\n", _RULE]
    parts += [f"{int(version)}. `{version.name}`: {text}\n" for version, text in BROUGHT.items()]
    for title, table in _OBJECTS.items():
        parts.append(f"\n## {title}\n\n| key | value | meaning |\n|---|---|---|\n")
        parts += [_field_row(name, field) for name, field in table.items()]
    for title, props in _PROPERTIES.items():
        parts.append(f"\n## {title}\n\n| property | value | default | meaning |\n|---|---|---|---|\n")
        parts += [_property_row(prop) for prop in props.values()]
    parts.append("\n## Example\n\n```json\n" + _example_text() + "```\n")
    return "".join(parts)


_PROPERTIES: Final = MappingProxyType({
    "Properties of the scene": OF_DOCUMENT,
    "Properties of a layer": OF_LAYER,
    "Properties of a set piece": OF_PIECE,
})  # fmt: skip

_OBJECTS: Final = MappingProxyType({
    "The project": fields.PROJECT,
    "`canvas`": fields.CANVAS,
    "`slate`": fields.SLATE,
    "`brought_light`": fields.BROUGHT_LIGHT,
    "A layer": fields.LAYER,
    "A set piece": fields.PIECE,
    "A track with keys": fields.TRACK,
    "A background over time": fields.BACKGROUND,
    "A key": fields.KEY,
    "A note": fields.NOTE,
})  # fmt: skip


def _field_row(name: str, field: fields.Field) -> str:
    return f"| `{name}` | {field.kind} | {field.meaning}{' May be missing.' if field.optional else ''} |\n"


def _property_row(prop: AnyProperty) -> str:
    default = f"`{formatted(prop.default).strip()}`" if prop.usual is Usual.DEFAULT else prop.usual.value
    return f"| `{prop.name}` | {_kind(prop)} | {default} | {prop.help} |\n"


def _kind(prop: AnyProperty) -> str:
    match prop.kind:
        case Kind.NUMBER:
            return f"number, {prop.low:g} to {prop.high:g}{prop.unit and ' ' + prop.unit}"
        case Kind.POINT:
            return f"[x, y] in {prop.unit}"
        case Kind.PLACE:
            return "[x, y, z] in px"
        case Kind.POINTS:
            return "[[x, y], …] in px"
        case Kind.COLOR:
            return '"#RRGGBB"'
        case Kind.CHOICE:
            return " or ".join(f'"{choice}"' for choice in prop.choices)
        case Kind.SWITCH:
            return "true or false"


def _example_text() -> str:
    """Return a small project as it is written, but for the program's version, which changes."""
    folder = Path("/cuts/c012")
    moving = (
        Key(1, (180.0, 60.0, 900.0), Interpolation.BEZIER, (EASY,) * 3, (EASY,) * 3),
        Key(24, (420.0, 60.0, 900.0)),
    )
    layer = Layer(
        id="layer-1",
        name="A",
        cels=Cels(
            (Drawing("1", folder / "A/A_0001.png"), Drawing("2", folder / "A/A_0002.png")),
            (Exposure(1, 0), Exposure(7, 1), Exposure(13, None)),
        ),
        figure=Box(212, 40, 388, 331),
        tracks=MappingProxyType({"shadow.opacity": Track(0.5)}),
    )
    document = Document(
        canvas=Canvas(640, 360, Fraction(24), 24),
        behind=still(folder.parent / "bg/street.png"),
        layers=(layer,),
        tracks=MappingProxyType({"light.position": Track(moving[0].value, moving)}),
        work_area=(1, 12),
        markers=(Marker(7, "step"),),
        notes=(
            Note(7, "shadow.opacity", "Lighter here", layer.id, "Sato", (NoteAnswer("0.6?", "Kim"),), is_done=True),
        ),
        pieces=(
            Piece("piece-1", "wall", MappingProxyType({"position": Track((320.0, 250.0)), "width": Track(900.0)})),
        ),
        linked=frozenset({"shadow.opacity"}),
    )
    return formatted({**tree_of(document, folder), "app_version": "0.1.0"})


if __name__ == "__main__":
    DESCRIPTION.write_text(description(), encoding="utf-8", newline="\n")
