"""Casts of a character and their filter jobs, without a drawing on any disk and without a graphics card."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.geometry.box import Box
from kagezou.geometry.contact import contact_plane
from kagezou.geometry.ground import canvas_from_plane
from kagezou.render.prepare.filter_charts import Receivers, charted
from kagezou.render.prepare.filter_job import FilterJob, blur_of, extent_of, stretched
from kagezou.render.prepare.occupancy import Occupancy
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import receivers_of
from kagezou.scene.evaluate import evaluate
from kagezou.scene.scene import Scene, ShadowCast
from tests.render.reference.figures import standing, with_values

CANVAS = Box(0, 0, 1000, 1000)
ELONGATED = np.array([[0.8, 0.3], [0.0, 1.25]])


@dataclass(frozen=True)
class DrawnMatte:
    """A matte that is nowhere but in memory."""

    box: Box
    occupancy: Occupancy


FIGURE = DrawnMatte(Box(346, 198, 674, 900), Occupancy(np.full((702, 328), 255, np.uint8), 0))
"""As large as the figure that the tests draw, and full."""


def document_with(values: Mapping[str, object], pieces: Mapping[str, Mapping[str, object]] | None = None) -> Document:
    """A character on the ground, with a set."""
    document = standing(Path("figure.png"))
    for name, each in (pieces or {}).items():
        document = add_piece(document, name, str(each["kind"]), {k: v for k, v in each.items() if k != "kind"})
    return with_values(document, values)


def scene_with(values: Mapping[str, object], pieces: Mapping[str, Mapping[str, object]] | None = None) -> Scene:
    """Its first frame."""
    return evaluate(document_with(values, pieces), 1)


def cast_of(scene: Scene) -> ShadowCast:
    """The cast of its one character."""
    cast = scene.layers[0].cast
    assert cast is not None
    return cast


def job_of(cast: ShadowCast, stretch: np.ndarray | None = None, receivers: Receivers | None = None) -> FilterJob:
    """The job of a cast on the ground, with its charts."""
    plane = contact_plane(cast.card, cast.receivers[0])
    blurred = np.eye(2) if stretch is None else stretch
    extent = extent_of(cast, FIGURE, stretched(canvas_from_plane(cast.camera, plane), blurred))
    assert extent is not None
    flat = FilterJob(cast, FIGURE, plane, blurred, extent, blur_of(cast, float(blurred[1, 1])))
    return charted(flat, Receivers({}) if receivers is None else receivers)


def scene_with_a_corner(values: Mapping[str, object]) -> tuple[Scene, FilterJob]:
    """A box on its corner, of which three faces that meet are reached: they do not unfold without a cut."""
    box = {"kind": "box", "position": [520, 850], "width": 120, "height": 160, "depth": 120, "angle": -35}
    scene = scene_with(values, {"box": box})
    cast = cast_of(scene)
    stage = SetAsSeen.of(scene.camera, CANVAS, scene.ground, scene.pieces)
    return scene, job_of(cast, receivers=receivers_of(stage, cast.lights[0]))
