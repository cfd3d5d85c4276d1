"""The kinds of export: each whole, and each doing what its preview says."""

import re
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import pytest

from kagezou.cli.main import VERBS
from kagezou.document import review
from kagezou.document.model import Document
from kagezou.document.set_pieces import add_piece
from kagezou.errors import UsageProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import Exporter, Option
from kagezou.export.exporters.farm_job import FARM_JOB
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.numbered_frames import NumberedFrames
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS, ShadowLayers
from kagezou.export.exporters.table import EXPORTERS, AnyExporter, exporter_of, sound
from kagezou.export.exporters.video_file import VIDEO_FILE
from kagezou.io.project.file import save
from kagezou.message import Message
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import cut, with_values

KEYS = [each.key for each in EXPORTERS]


@pytest.fixture
def document(tmp_path: Path) -> Document:
    """A character that receives, a set piece that casts, a work area."""
    made = add_piece(cut(tmp_path, count=2, length=4), "wall", "wall", {"width": 60.0, "height": 20.0})
    made = with_values(made, **{"layers.A.receives": True, "set.wall.casts": True})
    return review.set_work_area(made, 2, 3)


@pytest.fixture
def place(tmp_path: Path, document: Document) -> Place:
    project = tmp_path / "walk.kage"
    save(document, project)
    return Place(tmp_path / "out", project, "walk")


def carried_out(exporter: AnyExporter, document: Document, choices: ExportChoices, place: Place) -> Any:
    return exporter.work(document, choices, place)(open_headless_context, lambda _done, _all: None, lambda: False)


def test_the_table_finds_each_by_what_is_chosen() -> None:
    assert len(set(KEYS)) == len(KEYS)
    assert [exporter_of(ExportChoices(key)) for key in KEYS] == list(EXPORTERS)
    assert exporter_of(sound(ExportChoices("of another version"))) is EXPORTERS[0]
    assert ExportChoices().kind == EXPORTERS[0].key, "what is chosen at first"


def test_every_option_is_a_choice_and_is_offered_by_someone() -> None:
    assert {option.value for option in Option} <= {field.name for field in fields(ExportChoices)}
    assert set(Option) == {option for exporter in EXPORTERS for option in exporter.options}


@pytest.mark.parametrize("exporter", EXPORTERS, ids=KEYS)
def test_the_command_line_makes_each_too(exporter: AnyExporter) -> None:
    assert exporter.verb in VERBS


def test_an_exporter_that_lacks_a_part_is_none() -> None:
    with pytest.raises(TypeError, match="label"):
        ShadowLayers(key="new", verb="new", options=frozenset())  # type: ignore[call-arg]

    class Unfinished(NumberedFrames):
        pass

    with pytest.raises(TypeError, match="abstract"):
        Unfinished(  # type: ignore[abstract]
            key="new", label=Message("New"), purpose=Message("new"), icon="export", verb="new", options=frozenset()
        )
    assert issubclass(NumberedFrames, Exporter)


@pytest.mark.parametrize("exporter", EXPORTERS, ids=KEYS)
@pytest.mark.parametrize("only_work_area", [False, True])
def test_what_the_preview_says_is_what_is_written(
    exporter: AnyExporter, document: Document, place: Place, *, only_work_area: bool
) -> None:
    choices = ExportChoices(
        exporter.key, only_work_area=only_work_area, composite=True, receivers=True, mattes=("core", "receivers")
    )
    choices = sound(choices)
    lines = exporter.preview(document, choices, place)
    outcome = carried_out(exporter, document, choices, place)
    assert (outcome.problem, outcome.cancelled, outcome.written) == (None, False, outcome.files)
    seen = {line.split("  ")[0] for line in lines if not line.startswith("    ")}
    for line in lines:
        if found := re.fullmatch(r"([^ ].*)/  (\d+) × (\.\w+)", line):
            files = list((place.folder / found[1]).glob(f"*{found[3]}"))
            assert len(files) == int(found[2]), line
        if found := re.fullmatch(r"([^ ].*)  × (\d+)", line):
            first = place.folder / found[1]
            assert first.is_file()
            assert len(list(first.parent.glob(f"*{first.suffix}"))) == int(found[2]), line
    there = {path.name for path in place.folder.iterdir() if not path.name.startswith(".")}
    assert {line.split("/")[0] for line in seen if " × " not in line} == there


def test_each_exporter_keeps_to_its_formats(document: Document, place: Place) -> None:
    for exporter in EXPORTERS:
        for form in exporter.formats(ExportChoices(exporter.key)):
            choices = sound(ExportChoices(exporter.key, format=form))
            assert choices.format == form
            exporter.request(document, choices, place)


def test_the_work_area_is_a_choice_of_frames(document: Document, place: Place) -> None:
    chosen = ExportChoices(only_work_area=True)
    assert SHADOW_LAYERS.request(document, chosen, place).frames == (2, 3)
    assert SHADOW_LAYERS.request(document, ExportChoices(), place).frames is None
    assert SHADOW_LAYERS.request(replace(document, work_area=None), chosen, place).frames is None


def test_a_job_makes_frames_of_layers_where_that_is_chosen(document: Document, place: Place) -> None:
    choices = sound(ExportChoices(FARM_JOB.key, in_one=True, composite=True, receivers=True))
    export = FARM_JOB.request(document, choices, place).job.export
    assert (export.layered, export.composite, export.receivers, export.format) == (True, False, False, "psd")
    assert export.folder == place.folder.with_name("walk_shadows")
    with pytest.raises(UsageProblem, match="save this one first"):
        FARM_JOB.request(document, choices, replace(place, project=None))


def test_a_video_is_called_as_what_it_shows(document: Document, place: Place) -> None:
    choices = ExportChoices(VIDEO_FILE.key, format="mov", video_layer="A")
    assert VIDEO_FILE.request(document, choices, place).path == place.folder / "walk_A_shadow.mov"
    assert VIDEO_FILE.lacks() is None


def test_a_video_that_cannot_be_written_here_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("kagezou.export.exporters.video_file.is_there", lambda: False)
    lacking = VIDEO_FILE.lacks()
    assert lacking is not None
    assert lacking.extra.name == "video"


def test_the_preview_names_all_pictures_of_a_background(document: Document, place: Place) -> None:
    behind = document.layers[0].cels
    lines = HAND_OFF.preview(replace(document, behind=behind), ExportChoices(HAND_OFF.key), place)
    assert "background/  2 × .png" in lines
    still = replace(behind, exposures=behind.exposures[:1])
    assert "background/background.png" in HAND_OFF.preview(
        replace(document, behind=still), ExportChoices(HAND_OFF.key), place
    )
