"""``kagezou set`` where a value means more than itself: a figure that is made to travel leaves its lamp."""

from pathlib import Path

from tests.cli.projects import Shell, make_drawings


def test_a_figure_that_is_sent_across_the_picture_is_lit_by_the_sun(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "p.kage"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'walk', 4, (640, 360))}") == 0
    assert shell.json("get", project, "light.kind") == "point"
    shell.ok("set", project, "layers.A.position=[0,180]", "--frame", 1)
    assert shell.json("get", project, "light.kind") == "point"
    assert shell("set", project, "layers.A.position=[600,180]", "--frame", 4) == 0
    assert "the light is the sun now" in shell.said
    assert shell.json("get", project, "light.kind") == "sun"


def test_a_lamp_that_was_set_stays(shell: Shell, tmp_path: Path) -> None:
    project = tmp_path / "p.kage"
    assert shell("new", project, "--character", f"A={make_drawings(tmp_path / 'walk', 4, (640, 360))}") == 0
    shell.ok("set", project, "light.position=[320,-100,300]")
    shell.ok("set", project, "layers.A.position=[0,180]", "--frame", 1)
    assert shell("set", project, "layers.A.position=[600,180]", "--frame", 4) == 0
    assert "turns round while the figure travels" in shell.said
    assert shell.json("get", project, "light.kind") == "point"
