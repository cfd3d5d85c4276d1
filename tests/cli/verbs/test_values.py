"""A project that begins with properties from a file: what they mean, and what is refused."""

import json
from pathlib import Path

import pytest

from tests.cli.projects import Shell, make_drawings


@pytest.fixture
def hero(tmp_path: Path) -> Path:
    return make_drawings(tmp_path / "hero")


def test_figures_lie_where_the_file_says_and_the_ground_is_below_them(shell: Shell, tmp_path: Path, hero: Path) -> None:
    values, project = tmp_path / "values.json", tmp_path / "walk.kage"
    keys = [{"frame": n, "value": [150, 100 + n], "interpolation": "linear"} for n in (1, 3)]
    values.write_text(json.dumps({"layers.Hero.position": {"keys": keys}, "layers.Hero.scale": [-200, 200]}))
    words = ("new", project, "--character", f"Hero={hero}", "--size", "300x200", "--no-feet")
    assert shell(*words) == 0
    drawn = shell.json("get", project, "ground.position")
    assert shell(*words, "--force", "--values", values) == 0, shell.said
    assert shell.json("get", project, "layers.Hero.scale") == [-200, 200]
    assert shell.json("get", project, "layers.Hero.position", "--frame", 2) == [150, 102]
    # The block stands 16 px below the middle of its drawing, which lies at (150, 101) twice as large and mirrored.
    assert drawn[1] == 116
    assert shell.json("get", project, "ground.position")[1] == 101 + 2 * 16
    values.write_text(json.dumps({"layers.Hero.rotation": 180, "ground.position": [7, 8]}))
    assert shell(*words, "--force", "--values", values) == 0, shell.said
    assert shell.json("get", project, "ground.position") == [7, 8], "as the file says"
    values.write_text(json.dumps({"layers.Hero.shadow.opacity": 0.25}))
    assert shell(*words, "--force", "--values", values) == 0, shell.said
    assert shell.json("get", project, "ground.position") == drawn


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[1]", "does not hold values"),
        ('{"layers.Hero.scale": "big"}', "does not hold values"),
        ('{"layers.Hero.scale": {"keys": []}}', "does not hold values"),
        ('{"layers.Nobody.scale": [1, 1]}', "there is no property 'layers.Nobody.scale'"),
    ],
)
def test_what_is_no_value_is_refused_and_nothing_is_written(
    shell: Shell, tmp_path: Path, hero: Path, text: str, said: str
) -> None:
    values, project = tmp_path / "values.json", tmp_path / "walk.kage"
    values.write_text(text)
    assert shell("new", project, "--character", f"Hero={hero}", "--no-feet", "--values", values) != 0
    assert said in shell.said
    assert not project.exists()
