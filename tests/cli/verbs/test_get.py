"""``kagezou get`` where what is shown is not what is set: the tilt that grounding points measure."""

from pathlib import Path

import pytest

from tests.cli.projects import Shell


def test_the_tilt_of_two_points_is_the_one_that_is_shown(shell: Shell, project: Path) -> None:
    shell.ok("set", project, "layers.Hero.tilt=20")
    assert shell.json("get", project, "layers.Hero.tilt") == 20
    assert "measured" not in shell.json("get", project, "layers.Hero.tilt", "--json")
    shell("set", project, "layers.Hero.grounding=[[24,40],[34,39]]")
    shown = shell.json("get", project, "layers.Hero.tilt")
    # The ground rises by tan 60° for each row; positive turns the right side away.
    assert shown == pytest.approx(-9.826, abs=0.01)
    assert shell.json("get", project, "layers.Hero.tilt", "--frame", 2) == shown
    table = shell.json("get", project, "layers.Hero.tilt", "--json")
    assert (table["value"], table["measured"]) == (shown, True)
    shell("set", project, "layers.Hero.stance=line")
    assert shell.json("get", project, "layers.Hero.tilt") == 20
    assert "measured" not in shell.json("get", project, "layers.Hero.upright", "--json")


def test_points_whose_shadow_collapses_say_so_once(shell: Shell, project: Path) -> None:
    assert shell("set", project, "light.position=[-32,-60,60]") == 0
    assert shell("set", project, "layers.Hero.grounding=[[24,42.3],[32,37.7]]") == 0
    assert "two grounding points leave" in shell.said
    shell.ok("set", project, "layers.Hero.shadow.opacity=0.5")


def test_a_lamp_that_comes_to_stand_above_a_figure_is_said(shell: Shell, project: Path) -> None:
    radius, simplify = (shell.json("get", project, f"light.overhead_{each}") for each in ("radius", "simplify"))
    x, _ = shell.json("get", project, "ground.position")
    assert radius > 0
    assert simplify > 0
    shell.ok("set", project, "light.overhead_radius=0")
    assert shell("set", project, f"light.position=[{x},-40,0]") == 0
    assert "in the plane of Hero's drawing on frame 1" in shell.said
    assert shell("set", project, f"light.overhead_radius={radius}") == 0
    assert "the lamp is straight above Hero on frame 1" in shell.said
    assert shell("set", project, "light.overhead_radius=30") == 0
    assert shell.said == ""


def test_a_wall_that_is_pushed_into_a_figure_is_said(shell: Shell, project: Path) -> None:
    assert shell("piece", project, "add", "back", "wall") == 0
    assert "pokes through" not in shell.said
    assert shell("set", project, "layers.Hero.upright=0", "set.back.position=[32,39]") == 0
    assert "Hero pokes through back on frame 1" in shell.said
    assert shell("set", project, "layers.Hero.shadow.opacity=0.5") == 0
    assert shell.said == ""
