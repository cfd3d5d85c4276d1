"""The sequences of an export, by what they show."""

from dataclasses import replace
from pathlib import Path

import pytest

from kagezou.document.edits import add_layer
from kagezou.document.model import Cels, Document
from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.export.file_names import NumberedName
from kagezou.export.planning import jobs_of, planned
from kagezou.export.request import RECEIVED, RECEIVERS, SHADOWS, ExportRequest
from kagezou.export.sequences import OutputSequence, sequences_of
from kagezou.export.subjects import (
    EVERYTHING,
    GROUND,
    SET,
    CompositeSubject,
    LayeredSubject,
    ReceivedSubject,
    ReceiverSubject,
    SetShadowSubject,
    ShadowSubject,
)
from kagezou.geometry.box import Box
from tests.export.small_cuts import cut, with_key, with_values


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """Names that look like folders of others: "A", "A_shadow" and "set", with a piece called "ground" that casts."""
    made = cut(tmp_path, count=2)
    for name in ("A_shadow", "set"):
        made = add_layer(made, name, Cels(), Box(0, 0, 1, 1))
    made = add_piece(made, "ground", "box", {"width": 4.0})
    return with_values(made, **{"layers.A.receives": True, "set.ground.casts": True})


def subjects(document: Document, **wishes: object) -> dict[str, object]:
    request = ExportRequest(Path("out"), **wishes)  # type: ignore[arg-type]
    return {sequence.label: sequence.subject for sequence in sequences_of(document, request)}


def test_every_sequence_knows_what_it_shows_and_whose_it_is(document: Document) -> None:
    found = sequences_of(document, ExportRequest(Path("out"), composite=True, receivers=True))
    assert [(each.label, each.subject, each.subject.owner) for each in found] == [
        ("A_shadow", ShadowSubject("layer-1"), "layer-1"),
        ("A_shadow_shadow", ShadowSubject("layer-2"), "layer-2"),
        ("set_shadow", ShadowSubject("layer-3"), "layer-3"),
        ("A_received", ReceivedSubject("layer-1"), "layer-1"),
        ("set__shadow", SetShadowSubject(), SET),
        ("ground_matte", ReceiverSubject(None), GROUND),
        ("ground_2_matte", ReceiverSubject(document.pieces[0].id), document.pieces[0].id),
        ("composite", CompositeSubject(), EVERYTHING),
    ]
    assert found[0].file(7) == Path("out/A_shadow/A_shadow_0007.png")


@pytest.mark.parametrize(
    ("only", "labels"),
    [
        (SHADOWS, ["A_shadow", "A_shadow_shadow", "set_shadow", "set__shadow"]),
        (RECEIVED, ["A_received"]),
        (RECEIVERS, ["ground_matte", "ground_2_matte"]),
    ],
)
def test_one_kind_may_be_asked_for_alone(document: Document, only: str, labels: list[str]) -> None:
    assert list(subjects(document, only=only)) == labels


def test_the_shadow_of_the_set_is_left_out_when_layers_are_named(document: Document) -> None:
    assert list(subjects(document, layers=("A",))) == ["A_shadow", "A_received"]


def test_layered_frames_are_one_sequence(document: Document) -> None:
    (found,) = subjects(document, layered=True, format="psd").values()
    assert isinstance(found, LayeredSubject)
    assert (found.has_set, found.is_whole) == (True, True)
    assert [(each.name, each.received) for each in found.layers] == [("A", (True,)), ("A_shadow", ()), ("set", ())]
    (one,) = subjects(document, layered=True, format="psd", layers=("set",)).values()
    assert one == LayeredSubject((found.layers[2],), has_set=False, is_whole=False)


def test_nothing_to_show_is_refused(document: Document) -> None:
    bare = replace(document, layers=(), pieces=())
    for wishes in ({}, {"layered": True, "format": "psd"}):
        with pytest.raises(UsageProblem, match="nothing to render"):
            subjects(bare, **wishes)


def test_a_plan_tells_which_picture_a_sequence_shows_on_each_frame(tmp_path: Path) -> None:
    document = with_key(cut(tmp_path, count=2, length=5), "layers.A.visible", 1, value=True)
    document = with_key(document, "layers.A.visible", 4, value=False)
    plan = planned(document, ExportRequest(tmp_path, composite=True))
    shadow, composite = plan.sequences
    assert plan.pictures_of(shadow) == plan.pictures_of(composite) == (0, 1, 1, 2, 2)
    assert plan.names == {"A": "A"}


def test_pictures_made_once_are_numbered_in_each_sequence(tmp_path: Path) -> None:
    plan = planned(cut(tmp_path, count=3, length=6), ExportRequest(tmp_path, composite=True, once=True))
    found = [(target.sequence.label, target.frame, target.path.name) for job in plan.jobs for target in job.targets]
    assert sorted(found) == sorted(
        (label, number, f"{label}_{number:04d}.png") for label in ("A_shadow", "composite") for number in (1, 2, 3)
    )


def test_a_picture_shared_by_two_sequences_is_one_job(tmp_path: Path) -> None:
    document = cut(tmp_path, count=1)
    (first,) = sequences_of(document, ExportRequest(tmp_path))
    second = OutputSequence(first.subject, "again", NumberedName(tmp_path / "again", "again_", ".png"))
    (job,) = jobs_of(document, [1], (first, second))
    assert [target.sequence for target in job.targets] == [first, second]
