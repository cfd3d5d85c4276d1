"""Styles on the command line: what is listed, put on, printed, kept and refused."""

from pathlib import Path

import pytest

from kagezou.document.style import LINES
from kagezou.io.project.file import load
from tests.cli.projects import Shell, make_drawings

SIZE = (640, 480)


@pytest.fixture(autouse=True)
def own_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """The user's styles of the test alone."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    return tmp_path / "config" / "kagezou" / "styles"


@pytest.fixture
def project(shell: Shell, tmp_path: Path) -> Path:
    """A project of one character, which is tall enough for every style."""
    path = tmp_path / "walk.kage"
    assert shell("new", path, f"--character=Hero={make_drawings(tmp_path / 'walk', size=SIZE)}") == 0
    return path


@pytest.fixture
def pair(shell: Shell, tmp_path: Path) -> Path:
    """A project of two characters."""
    path = tmp_path / "pair.kage"
    characters = [f"--character={name}={make_drawings(tmp_path / name, size=SIZE)}" for name in ("Hero", "Dog")]
    assert shell("new", path, *characters) == 0
    return path


def test_they_are_listed_in_both_languages(shell: Shell) -> None:
    lines = dict(line.split("\t") for line in shell.ok("style").splitlines())
    assert lines["Water"] == "水面"


class TestPuttingOn:
    @pytest.mark.parametrize("name", ["water", "水面"])
    def test_one_is_put_on(self, shell: Shell, project: Path, name: str) -> None:
        shell.ok("style", project, name)
        assert float(shell.ok("get", project, "layers.Hero.shadow.wave1.amplitude")) > 0
        assert shell.ok("get", project, "layers.Hero.shadow.color").strip().strip('"') == "#0E3A52"

    def test_what_it_changes_is_printed_as_get_and_set_write_it(self, shell: Shell, project: Path) -> None:
        lines = shell.ok("style", project, "water").splitlines()
        assert 'layers.Hero.shadow.color "#20203A" -> "#0E3A52"' in lines
        assert "layers.Hero.shadow.opacity 0.6 -> 0.55" in lines
        for line in lines:
            path, values = line.split(" ", 1)
            before, after = values.split(" -> ")
            assert shell.ok("get", project, path).strip() == after != before
        kept = project.read_bytes()
        assert shell.ok("style", project, "water") == ""
        assert project.read_bytes() == kept

    def test_keys_that_are_set_are_named(self, shell: Shell, project: Path) -> None:
        shell.ok("set", project, "layers.Hero.shadow.opacity=0.2", "--frame", 1)
        assert shell("style", project, "water", "--layer", "Hero", "--frame", 3) == 0
        assert shell.said == "kagezou: note: 1 keyed property got a key on frame 3: layers.Hero.shadow.opacity\n"
        assert "layers.Hero.shadow.opacity 0.2 -> 0.55" in shell.out

    def test_a_dry_run_prints_the_same_and_writes_nothing(self, shell: Shell, project: Path) -> None:
        kept = project.read_bytes()
        would = shell.ok("style", project, "water", "--dry-run")
        assert would
        assert project.read_bytes() == kept
        assert shell.ok("style", project, "water") == would

    def test_what_there_is_not_is_one_line(self, shell: Shell, project: Path) -> None:
        assert "Torn water" in shell.fails(2, "style", project, "torn watr")
        shell.fails(2, "style", project)
        shell.fails(2, "style", project, "water", "--layer", "Nobody")


class TestLight:
    def test_it_is_left_out_and_said_unless_it_is_asked_for(self, shell: Shell, project: Path) -> None:
        before = load(project).tracks
        assert shell("style", project, "long evening") == 0
        assert shell.said == "kagezou: note: Long evening came without its own light: --with-light brings that too\n"
        assert "light." not in shell.out
        assert load(project).tracks == before
        lines = shell.ok("style", project, "long evening", "--with-light").splitlines()
        assert "light.elevation" in {line.split()[0] for line in lines}
        assert shell.ok("get", project, "light.kind").strip() == '"sun"'

    def test_with_the_next_style_it_goes(self, shell: Shell, project: Path) -> None:
        before = load(project).tracks
        shell.ok("style", project, "long evening", "--with-light")
        assert shell("style", project, "simple") == 0
        assert "taken back" in shell.said
        assert load(project).tracks == before

    def test_it_never_comes_for_one_of_several(self, shell: Shell, pair: Path) -> None:
        kept = pair.read_bytes()
        shell.fails(2, "style", pair, "long evening", "--layer", "Hero", "--with-light")
        assert pair.read_bytes() == kept
        assert shell("style", pair, "long evening", "--with-light") == 0
        assert shell.ok("get", pair, "light.kind").strip() == '"sun"'

    def test_a_style_without_one_says_so(self, shell: Shell, project: Path) -> None:
        assert shell("style", project, "water", "--with-light") == 0
        assert shell.said == "kagezou: note: Water has no light of its own\n"


class TestKeeping:
    def test_a_look_with_its_light_comes_back_on_another_project(
        self, shell: Shell, project: Path, pair: Path, own_folder: Path
    ) -> None:
        shell.ok("set", project, "layers.Hero.shadow.tip_color=#123456", "light.kind=sun", "light.azimuth=12.5")
        shell.ok("set", project, "ground.roll=1.5", "camera.fov=30", "layers.Hero.shadow.blend=normal")
        path = shell.ok("style", project, "--save", "Night", "--with-light").strip()
        assert Path(path) == own_folder / "Night.json"
        shell.ok("style", pair, "night", "--with-light")
        wanted, there = load(project), load(pair)
        for line in LINES:
            assert there.layers[0].tracks.get(line.name) == wanted.layers[0].tracks.get(line.name)
        paths = ("light.kind", "light.azimuth", "light.position", "ground.roll", "ground.position", "camera.fov")
        for each in paths:
            assert shell.ok("get", pair, each) == shell.ok("get", project, each)

    def test_without_the_wish_the_light_stays_where_it_is(self, shell: Shell, project: Path, own_folder: Path) -> None:
        shell.ok("style", project, "--save", "Plain")
        assert "scene" not in (own_folder / "Plain.json").read_text("utf-8")

    def test_one_of_the_same_name_is_replaced_and_that_is_said(self, shell: Shell, project: Path) -> None:
        path = shell.ok("style", project, "--save", "Mine").strip()
        assert shell("style", project, "--save", "Mine") == 0
        assert shell.said == f"kagezou: note: {path} is replaced\n"

    def test_a_dry_run_keeps_nothing(self, shell: Shell, project: Path, own_folder: Path) -> None:
        shell.ok("style", project, "--save", "Mine", "--dry-run")
        assert not own_folder.exists()

    def test_it_must_be_clear_whose_look_is_meant(self, shell: Shell, pair: Path) -> None:
        assert "'Hero', 'Dog'" in shell.fails(2, "style", pair, "--save", "Mine")
        shell.ok("style", pair, "--save", "Mine", "--layer", "Dog")
        shell.fails(2, "style", pair, "water", "--save", "Mine", "--layer", "Dog")
        shell.fails(2, "style", "--save", "Mine")
