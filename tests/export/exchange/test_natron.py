"""Scenes for Natron: what its nodes make of them is the composite."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

from kagezou.export.choices import ExportChoices, Place
from kagezou.export.exchange.export import SceneMade
from kagezou.export.exchange.natron import NATRON
from kagezou.export.exporters.natron_scene import NATRON_SCENE
from tests.export.exchange.cuts import composites, levels_apart, made, rich_cut, united_cut
from tests.export.exchange.fake_natron import App
from tests.export.small_cuts import HEIGHT, WIDTH


def built(done: SceneMade) -> App:
    """Return the project that the script builds when Natron imports it."""
    assert done.scene is not None
    spec = importlib.util.spec_from_file_location("scene", done.scene)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    app = App()
    module.createInstance(app, app)
    return app


@pytest.mark.parametrize("kind", ["rich", "clear", "united"])
def test_its_nodes_make_the_composite(kind: str, tmp_path: Path) -> None:
    folder = tmp_path / "in"
    document = united_cut(folder) if kind == "united" else rich_cut(folder, background=kind == "rich")
    app = built(made(document, tmp_path / "新しい 場所", NATRON))
    output = app.nodes[-1]
    assert (output.plugin, output.script_name) == ("fr.inria.built-in.Output", "Output1")
    for place, picture in enumerate(composites(document, tmp_path / "ref")):
        got = output.shown(101 + place, (WIDTH, HEIGHT))
        wanted = np.concatenate([picture[..., :3] * picture[..., 3:], picture[..., 3:]], -1)
        assert levels_apart(got, wanted) <= 1


def test_the_project_has_the_cuts_size_and_time(tmp_path: Path) -> None:
    app = built(made(rich_cut(tmp_path / "in"), tmp_path / "out", NATRON))
    assert app.formats == ["kagezou_64x48 64x48 1"]
    assert app.params["outputFormat"].value == "kagezou_64x48"
    assert app.params["frameRange"].value == (101, 108)
    assert app.params["frameRate"].value == pytest.approx(24000 / 1001)
    last = app.nodes[-2]
    assert (last.params["ocioInputSpace"].value, last.params["ocioOutputSpace"].value) == ("sRGB", "Linear")
    labels = [node.label for node in app.nodes if node.plugin == "read"]
    assert labels == ["background", "主役 #1_shadow", "相棒_shadow", "主役 #1", "相棒"]


def test_the_script_can_be_imported_whatever_the_cut_is_called(tmp_path: Path) -> None:
    document = rich_cut(tmp_path / "in")
    place = Place(tmp_path / "out", None, "カット 12-b")
    request = NATRON_SCENE.request(document, ExportChoices(NATRON_SCENE.key), place)
    stem = request.file.removesuffix(".py")
    assert stem.isascii()
    assert stem.isidentifier()
