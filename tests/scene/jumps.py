"""Cuts in which a figure jumps: it stands on two feet, and each drawing shows it so high over the ground."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from kagezou.document import edits
from kagezou.document.address import Address
from kagezou.document.model import Canvas, Cels, Document, Drawing, Exposure
from kagezou.document.properties import OF_DOCUMENT, OF_LAYER
from kagezou.geometry.box import Box
from kagezou.standing.foot import Foot

RISES = (0, 0, 0, 0, 40, 90, 120, 90, 40, 0, 0, 0, 0)
"""In the air in the drawings 5 to 9, highest in 7."""

TALL = 400
FEET = ((450.0, 900.0), (550.0, 900.0))
GROUND = 900


def jumping(
    rises: Sequence[int] = RISES,
    paths: Sequence[Path] | None = None,
    boxes: Sequence[Box] | None = None,
    **values: object,
) -> Document:
    """Return a cut of 1000 x 1000 px in which a figure 400 px high jumps; keywords are properties, ``__`` for dots.

    ``paths`` are the drawings' files, ``boxes`` those around the figure in each.
    """
    drawings = []
    for index, up in enumerate(rises):
        drawings.append(
            Drawing(
                str(index + 1),
                Path(f"/c/{index + 1}.png") if paths is None else paths[index],
                size_px=(1000, 1000),
                figure=standing_box(up) if boxes is None else boxes[index],
                feet=tuple(Foot(track, (x, y - up)) for track, (x, y) in enumerate(FEET)),
            )
        )
    cels = Cels(tuple(drawings), tuple(Exposure(index + 1, index) for index in range(len(drawings))))
    document = Document(Canvas(1000, 1000, length_frames=len(drawings)))
    document = edits.add_layer(document, "A", cels, Box(400, GROUND - TALL, 600, GROUND))
    return with_values(document, {"ground.position": [500, GROUND], "light.kind": "sun"} | named(values))


def standing_box(up: int, tall: int = TALL) -> Box:
    """Return the box around a figure so high over the ground."""
    return Box(400, GROUND - up - tall, 600, GROUND - up)


def named(values: dict[str, object]) -> dict[str, object]:
    """Return keywords by the names they stand for."""
    return {key.replace("__", "."): value for key, value in values.items()}


def with_values(document: Document, values: Mapping[str, object], layer_id: str = "layer-1") -> Document:
    """Set constants of the document and of a layer."""
    for name, raw in values.items():
        address = Address(OF_DOCUMENT[name]) if name in OF_DOCUMENT else Address(OF_LAYER[name], layer_id)
        document = edits.set_constant(document, address, raw)
    return document
