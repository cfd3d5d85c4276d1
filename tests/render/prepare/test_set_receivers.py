"""What of a set a filtered shadow is laid on, by the switches of its pieces."""

from collections.abc import Mapping

from kagezou.geometry.sets.faces_seen import GROUND
from kagezou.render.prepare.set_as_seen import SetAsSeen
from kagezou.render.prepare.set_receivers import blocks, casts, receivers_of, views_of
from kagezou.scene.scene import Scene
from tests.render.prepare.filter_jobs import CANVAS, cast_of, job_of, scene_with

SIMPLIFIED = {"layers.A.shadow.simplify": 12.0}
SET = {
    "wall": {"kind": "wall", "position": [500, 780], "width": 900, "height": 400},
    "box": {"kind": "box", "position": [620, 850], "width": 120, "height": 90, "depth": 80},
}


def scene_of(values: Mapping[str, object]) -> tuple[Scene, SetAsSeen]:
    scene = scene_with({**SIMPLIFIED, **values}, SET)
    return scene, SetAsSeen.of(scene.camera, CANVAS, scene.ground, scene.pieces)


def test_pieces_that_cast_block_too() -> None:
    scene, _ = scene_of({"set.box.casts": True, "set.box.blocks": False, "set.wall.blocks": False})
    wall, box = scene.pieces
    assert (blocks(wall), casts(wall)) == (False, False)
    assert (blocks(box), casts(box)) == (True, True)


def test_bodies_that_do_not_receive_are_left_out_and_keep_their_numbers() -> None:
    scene, stage = scene_of({"set.wall.receives": False})
    light = cast_of(scene).lights[0]
    receivers = receivers_of(stage, light)
    assert {stage.owners[index].name for index in receivers.bodies} == {"box"}
    assert all(stage.bodies[index] is body for index, body in receivers.bodies.items())


def test_what_blockers_take_of_the_ground_is_no_receiver() -> None:
    scene, stage = scene_of({})
    light = cast_of(scene).lights[0]
    assert len(receivers_of(stage, light).unlit) == 2
    scene, stage = scene_of({"set.box.blocks": False})
    assert len(receivers_of(stage, light).unlit) == 1
    scene, stage = scene_of({"set.box.blocks": False, "set.wall.blocks": False})
    assert receivers_of(stage, light).unlit == ()


def test_the_ground_and_every_face_laid_flat_that_is_seen_show_a_job_once() -> None:
    scene, stage = scene_of({})
    cast = cast_of(scene)
    job = job_of(cast, receivers=receivers_of(stage, cast.lights[0]))
    looked_up = [sheet for sheet in job.development.sheets if sheet.is_looked_up]
    assert looked_up, "the shadow reaches the wall"
    views = list(views_of(stage, job))
    (ground,) = [view for face, view in views if face.body == GROUND]
    assert (ground.chart, ground.receiver) == (0, cast.receivers[0])
    shown = [(face, view) for face, view in views if face.body != GROUND]
    assert len({id(face) for face, _ in shown}) == len(shown)
    for face, view in shown:
        (sheet,) = [each for each in looked_up if (each.face.body, each.face.plane) == (face.body, face.plane)]
        assert (view.receiver, view.chart, view.box) == (face.plane, sheet.chart, face.box)
    seen = {(face.body, face.plane) for face in stage.faces}
    assert len(shown) == sum((sheet.face.body, sheet.face.plane) in seen for sheet in looked_up)


def test_on_flat_ground_the_ground_alone_shows_a_job() -> None:
    scene = scene_with(SIMPLIFIED)
    stage = SetAsSeen.of(scene.camera, CANVAS, scene.ground, ())
    ((face, view),) = views_of(stage, job_of(cast_of(scene)))
    assert (face.body, view.chart, view.joins) == (GROUND, 0, ())
