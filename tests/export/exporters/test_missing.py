"""A drawing that is not there, by every kind of export: refused with its name, left empty, or its neighbour held."""

import json
from pathlib import Path

import av
import pytest

from kagezou.document.edits import add_layer
from kagezou.document.model import Cels, Exposure
from kagezou.errors import InputProblem
from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exporters.exporter import ExportOutcome, Option
from kagezou.export.exporters.farm_job import FARM_JOB
from kagezou.export.exporters.hand_off import HAND_OFF
from kagezou.export.exporters.shadow_layers import SHADOW_LAYERS
from kagezou.export.exporters.table import EXPORTERS, AnyExporter, sound
from kagezou.export.exporters.video_file import VIDEO_FILE
from kagezou.export.farm import ASSETS
from kagezou.export.remembered import dumps_choices, loads_choices
from kagezou.export.request import Missing
from kagezou.geometry.box import Box
from kagezou.io.images.reading import read_cel
from kagezou.io.project.file import save
from kagezou.render.gpu.context import open_headless_context
from tests.export.small_cuts import bytes_below, cut, drawings, with_values

KEYS = [each.key for each in EXPORTERS]
DRAWING_HERE = [each for each in EXPORTERS if each is not FARM_JOB]
LOST = 3
SAID = {
    Missing.EMPTY: "A: missing, so left empty on frames 3: a_0003.png",
    Missing.HOLD: "A: missing, so the nearest drawing is held on frames 3: a_0003.png",
}


def carried_out(exporter: AnyExporter, folder: Path, missing: str, out: str = "out") -> ExportOutcome:
    """Export a cut of four drawings whose third is not there."""
    document = cut(folder, count=4)
    (folder / "drawings" / f"a_{LOST:04d}.png").unlink()
    project = folder / "walk.kage"
    save(document, project)
    choices = sound(ExportChoices(exporter.key, missing=missing))
    work = exporter.work(document, choices, Place(folder / out, project, "walk"))
    return work(open_headless_context, lambda _done, _all: None, lambda: False)


@pytest.mark.parametrize("exporter", EXPORTERS, ids=KEYS)
def test_every_kind_lets_one_choose(exporter: AnyExporter) -> None:
    assert Option.MISSING in exporter.options


@pytest.mark.parametrize("exporter", DRAWING_HERE, ids=[each.key for each in DRAWING_HERE])
def test_it_is_refused_with_its_name_before_anything_is_made(exporter: AnyExporter, tmp_path: Path) -> None:
    with pytest.raises(InputProblem, match=r"a_0003\.png: the drawing is missing"):
        carried_out(exporter, tmp_path, Missing.FAIL)
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == []


@pytest.mark.parametrize("exporter", DRAWING_HERE, ids=[each.key for each in DRAWING_HERE])
@pytest.mark.parametrize("way", [Missing.EMPTY, Missing.HOLD])
def test_what_stands_in_makes_it_whole_and_is_said_once(exporter: AnyExporter, way: Missing, tmp_path: Path) -> None:
    came = carried_out(exporter, tmp_path, way)
    assert (came.is_whole, came.problem) == (True, None)
    assert [str(each) for each in came.notes].count(SAID[way]) == 1
    assert sum("a_0003.png" in str(each) for each in came.notes) == 1


def test_a_video_holds_or_leaves_empty(tmp_path: Path) -> None:
    held = carried_out(VIDEO_FILE, tmp_path, Missing.HOLD, "held").where
    empty = carried_out(VIDEO_FILE, tmp_path, Missing.EMPTY, "empty").where
    frames = {}
    for path in (held, empty):
        with av.open(str(path)) as film:
            frames[path] = [each.to_ndarray(format="gray").astype(int) for each in film.decode(video=0)]
    assert len(frames[held]) == len(frames[empty]) == 4
    assert abs(frames[held][2] - frames[held][1]).mean() < 1
    assert frames[empty][2].min() > 200 > frames[empty][1].min()


def test_a_hand_off_shows_the_neighbour_and_the_shadow_of_it(tmp_path: Path) -> None:
    carried_out(HAND_OFF, tmp_path, Missing.HOLD)
    shadows = tmp_path / "out" / "shadows" / "A_shadow"
    assert (shadows / "A_shadow_0003.png").read_bytes() == (shadows / "A_shadow_0002.png").read_bytes()
    assert len(list((tmp_path / "out" / "characters" / "A").iterdir())) == 3


def test_a_hand_off_leaves_the_frame_empty(tmp_path: Path) -> None:
    carried_out(HAND_OFF, tmp_path, Missing.EMPTY)
    shadows = tmp_path / "out" / "shadows" / "A_shadow"
    seen = [bool(read_cel(path).rgba[..., 3].any()) for path in sorted(shadows.glob("*.png"))]
    assert seen == [True, True, False, True]


def test_a_hand_off_needs_drawings_that_cast_nothing(tmp_path: Path) -> None:
    """The characters are footage as well: what is exposed is needed, though no shadow is made of it."""
    document = with_values(cut(tmp_path, count=2), layers__A__visible=False)
    document = add_layer(document, "B", Cels(drawings(tmp_path / "b", 1, "b"), (Exposure(1, 0),)), Box(1, 1, 2, 2))
    (tmp_path / "drawings" / "a_0002.png").unlink()
    work = HAND_OFF.work(document, ExportChoices(HAND_OFF.key, missing="hold"), Place(tmp_path / "out", None, "walk"))
    came = work(open_headless_context, lambda _done, _all: None, lambda: False)
    assert came.is_whole
    assert [path.name for path in (tmp_path / "out" / "characters" / "A").iterdir()] == ["A_0001.png"]


def test_a_job_carries_it_to_its_workers_and_names_only_what_is_there(tmp_path: Path) -> None:
    carried_out(FARM_JOB, tmp_path, Missing.HOLD)
    template = json.loads((tmp_path / "out" / "template.json").read_text(encoding="utf-8"))
    (asked,) = [each for each in template["parameterDefinitions"] if each["name"] == "Missing"]
    assert (asked["default"], asked["allowedValues"]) == ("hold", ["fail", "empty", "hold"])
    words = template["steps"][0]["script"]["actions"]["onRun"]["args"]
    assert words[words.index("--missing") + 1] == "{{Param.Missing}}"
    named = json.loads((tmp_path / "out" / ASSETS).read_text(encoding="utf-8"))["assetReferences"]["inputs"]
    assert {Path(each).name for each in named["filenames"]} == {"walk.kage", *(f"a_000{n}.png" for n in (1, 2, 4))}


def test_it_is_remembered_and_what_is_not_known_is_usual(tmp_path: Path) -> None:
    chosen = ExportChoices(SHADOW_LAYERS.key, missing="hold")
    assert loads_choices(dumps_choices(chosen)) == chosen
    assert loads_choices(dumps_choices(chosen).replace('"hold"', '"invent"')).missing == "fail"
    assert loads_choices("{}").missing == "fail"
    carried_out(SHADOW_LAYERS, tmp_path, "hold")
    assert len(bytes_below(tmp_path / "out")) == 4
