"""What is particular to each kind of set piece, in one table.

A new kind is a member of `PieceKind`, a row here, a shape in `geometry.sets.shapes` and its words in
`ui.system.kind_words`; where one of them is forgotten, the program does not start.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from kagezou.document.model import Piece
from kagezou.document.property import AnyProperty
from kagezou.document.set_properties import (
    PIECE_ANCHOR,
    PIECE_ANGLE,
    PIECE_COUNT,
    PIECE_DEPTH,
    PIECE_DISPLAY,
    PIECE_HEIGHT,
    PIECE_KIND,
    PIECE_LEAN,
    PIECE_SCALE,
    PIECE_UNDER,
    PIECE_UP,
    PIECE_WIDTH,
)
from kagezou.document.values import value_at
from kagezou.geometry.sets.measures import PieceKind, by_kind
from kagezou.message import Message

Size = tuple[float, float, float]
"""Width, height and depth."""


@dataclass(frozen=True, slots=True)
class FirstSizes:
    """How large a new piece is.

    Parameters
    ----------
    of_canvas
        As parts of the canvas' smaller side, where nothing else is known.
    of_figure
        In heights of the figure beside which it is put.
    """

    of_canvas: Size
    of_figure: Size


@dataclass(frozen=True, slots=True)
class PieceTraits:
    """What is particular to a kind.

    Parameters
    ----------
    label
        What it is called.
    measures
        The properties that not all kinds have but this one has; the others of `MEASURES` mean nothing for it.
    first_sizes
        How large a new one is; None for a kind that is not built from measures.
    is_backdrop
        Whether it stands behind the figure, and what else there is may stand before it; others stand beside it.
    rises_to_back
        Whether it is as high as it is only at its back edge.
    """

    label: Message
    measures: frozenset[AnyProperty]
    first_sizes: FirstSizes | None
    is_backdrop: bool = False
    rises_to_back: bool = False


_BLOCK = frozenset({PIECE_ANGLE, PIECE_WIDTH, PIECE_HEIGHT, PIECE_DEPTH})

TRAITS: Final[Mapping[PieceKind, PieceTraits]] = by_kind({
    PieceKind.WALL: PieceTraits(
        Message("Wall"),
        frozenset({PIECE_ANGLE, PIECE_LEAN, PIECE_WIDTH, PIECE_HEIGHT}),
        FirstSizes(of_canvas=(0.8, 0.6, 0.2), of_figure=(2.4, 1.3, 0.2)),
        is_backdrop=True,
    ),
    PieceKind.BOX: PieceTraits(
        Message("Box"),
        _BLOCK,
        FirstSizes(of_canvas=(0.25, 0.2, 0.2), of_figure=(0.5, 0.4, 0.4)),
    ),
    PieceKind.STEPS: PieceTraits(
        Message("Steps", "a set piece to walk up"),
        _BLOCK | {PIECE_COUNT},
        FirstSizes(of_canvas=(0.35, 0.2, 0.35), of_figure=(0.7, 0.4, 0.7)),
        rises_to_back=True,
    ),
    PieceKind.RAMP: PieceTraits(
        Message("Ramp"),
        _BLOCK,
        FirstSizes(of_canvas=(0.3, 0.15, 0.4), of_figure=(0.6, 0.3, 0.8)),
        rises_to_back=True,
    ),
    PieceKind.CYLINDER: PieceTraits(
        Message("Cylinder"),
        frozenset({PIECE_WIDTH, PIECE_HEIGHT}),
        FirstSizes(of_canvas=(0.15, 0.35, 0.15), of_figure=(0.3, 0.7, 0.3)),
    ),
    PieceKind.SPHERE: PieceTraits(
        Message("Sphere"),
        frozenset({PIECE_WIDTH}),
        FirstSizes(of_canvas=(0.2, 0.2, 0.2), of_figure=(0.4, 0.4, 0.4)),
    ),
    PieceKind.MESH: PieceTraits(
        Message("3-D set"),
        frozenset({PIECE_ANGLE, PIECE_SCALE, PIECE_UP, PIECE_ANCHOR, PIECE_DISPLAY, PIECE_UNDER}),
        None,
    ),
})  # fmt: skip

MEASURES: Final = frozenset[AnyProperty]().union(*(traits.measures for traits in TRAITS.values()))
"""The properties of set pieces that mean something for some kinds only."""

BUILT_KINDS: Final = tuple(kind for kind, traits in TRAITS.items() if traits.first_sizes is not None)
"""What can be put onto the ground by its measures alone."""


def kind_of(piece: Piece, frame: float = 1) -> PieceKind:
    """Return what a piece is at a frame."""
    return PieceKind(value_at(piece.tracks, PIECE_KIND, frame))


def matters(prop: AnyProperty, kind: PieceKind) -> bool:
    """Whether a property of a set piece means anything for a kind."""
    return prop not in MEASURES or prop in TRAITS[kind].measures
