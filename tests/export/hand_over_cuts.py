"""Cuts for comparing hand-overs with the picture: sets, received shadows, joined cels, looks and blends, combined."""

from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Final

import numpy as np

from kagezou.animation.track import Interpolation
from kagezou.document.address import resolve
from kagezou.document.edits import add_layer, join_layer, set_background, set_key
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box
from kagezou.io.images.writing import write_rgba
from tests.export.small_cuts import HEIGHT, WIDTH, cut, drawings, with_key, with_values

FRAMES: Final = 3
SETS: Final = ("none", "clay", "clay under", "clay and walls")
RECEIVED: Final = ("none", "received")
JOINED: Final = ("apart", "joined")
LOOKS: Final = ("alike", "unlike", "keyed", "tips", "companions")
BLENDS: Final = ("multiply", "normal", "mixed", "keyed")


@dataclass(frozen=True, slots=True)
class Combination:
    """One of each."""

    set: str
    received: str
    joined: str
    look: str
    blend: str

    @property
    def parts(self) -> tuple[str, ...]:
        """All of them."""
        return (self.set, self.received, self.joined, self.look, self.blend)

    def __str__(self) -> str:
        return ", ".join(self.parts)


EVERY: Final = tuple(Combination(*each) for each in product(SETS, RECEIVED, JOINED, LOOKS, BLENDS))


def combined(wanted: Combination, folder: Path) -> Document:
    """Return a cut of two figures, one of which has two cels, over a background with clear parts."""
    document = _figures(folder)
    if wanted.joined == "joined":
        document = join_layer(document, document.layers[2].id, document.layers[0].id)
    if wanted.received == "received":
        document = with_values(document, layers__A__receives=True, layers__B__receives=True)
    document = _with_set(document, wanted.set, folder)
    return _with_blend(_with_look(document, wanted.look), wanted.blend)


def _figures(folder: Path) -> Document:
    document = cut(folder / "a", FRAMES)
    shown = drawings(folder / "b", FRAMES, "b")
    later = tuple(Exposure(n + 1, (n + 1) % FRAMES) for n in range(FRAMES))
    document = add_layer(document, "B", Cels(shown, later), Box(12, 20, 20, 40))
    hat = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
    hat[14:22, 14:26] = (30, 160, 90, 255)
    hat[14:22, 13] = (30, 160, 90, 120)
    write_rgba(folder / "hat.png", hat)
    cels = Cels((Drawing("1", folder / "hat.png"),), (Exposure(1, 0),))
    document = add_layer(document, "C", cels, Box(14, 14, 26, 22))
    ramp = np.full((HEIGHT, WIDTH, 4), 255, np.uint8)
    ramp[..., 0], ramp[..., 1] = np.linspace(40, 250, WIDTH), np.linspace(90, 220, HEIGHT)[:, np.newaxis]
    ramp[:12, :20, 3] = 0
    write_rgba(folder / "ramp.png", ramp)
    document = set_background(document, folder / "ramp.png")
    return with_values(
        document,
        layers__A__shadow__softness=9.0,
        layers__B__shadow__softness=6.0,
        layers__A__grounding=[[16, 36]],
        layers__B__grounding=[[14, 42]],
        light__position=[8, -10, 90],
    )


def _with_set(document: Document, name: str, folder: Path) -> Document:
    if name == "none":
        return document
    corners = [(x, y, z) for x in (-1, 1) for y in (0, 1) for z in (-1, 1)]
    quads = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
    text = "".join(f"v {x * 8} {y * 16} {z * 8}\n" for x, y, z in corners) + "".join(f"f {each}\n" for each in quads)
    (folder / "crate.obj").write_text(text)
    under = name == "clay under"
    measures = {"scale": 1.0, "angle": 25.0, "position": (44.0, 36.0), "display": "clay", "under": under}
    document = add_piece(document, "crate", "mesh", measures, folder / "crate.obj")
    for frame, angle in ((1, 25.0), (FRAMES, 70.0)):
        document = with_key(document, "set.crate.angle", frame, angle)
    if name == "clay and walls":
        more = {"scale": 0.6, "position": (12.0, 12.0), "display": "clay", "under": True}
        document = add_piece(document, "below", "mesh", more, folder / "crate.obj")
        wall = {"width": 90.0, "height": 30.0, "position": (32.0, 30.0), "casts": True}
        document = add_piece(document, "wall", "wall", wall)
        document = with_values(document, **{"set.shadow.opacity": 0.35, "set.shadow.color": "#402010"})
    return document


def _with_look(document: Document, name: str) -> Document:
    match name:
        case "unlike":
            return with_values(
                document,
                layers__B__shadow__color="#803010",
                layers__B__shadow__opacity=0.35,
                layers__B__shadow__fade=30.0,
            )
        case "keyed":
            document = with_key(
                with_key(document, "layers.A.shadow.opacity", 1, 0.9), "layers.A.shadow.opacity", 3, 0.3
            )
            document = with_values(document, layers__A__shadow__color="#102060")
            return with_values(document, layers__A__shadow__timing="exposures")
        case "tips":
            tip = {"shadow.tip_distance": 20.0, "shadow.tip_color": "#C04020"}
            return with_values(document, **{f"layers.{n}.{path}": value for n in "AB" for path, value in tip.items()})
        case "companions":
            more = {"contact.strength": 0.8, "contact.size": 4.0, "reflection.opacity": 0.5}
            return with_values(document, **{f"layers.A.{path}": value for path, value in more.items()})
    return document


def _with_blend(document: Document, name: str) -> Document:
    match name:
        case "normal":
            return with_values(document, layers__A__shadow__blend="normal", layers__B__shadow__blend="normal")
        case "mixed":
            return with_values(document, layers__B__shadow__blend="normal")
        case "keyed":
            address = resolve(document, "layers.A.shadow.blend")
            for frame, value in ((1, "multiply"), (2, "normal"), (3, "multiply")):
                document = set_key(document, address, frame, value, Interpolation.HOLD)
    return document
