"""What a studio keeps in folders of its own: below the user's, above the program's."""

import os
from pathlib import Path
from types import MappingProxyType

import pytest

from kagezou.document.local_name import LocalName
from kagezou.document.style import Style
from kagezou.errors import UsageProblem
from kagezou.export.choices import ExportChoices
from kagezou.export.presets import presets_there, save_preset
from kagezou.io.clips.shortcut_files import KeySet, bundled_key_sets, key_sets_there, save_key_set
from kagezou.io.clips.style_files import bundled_styles, named_style, save_style, styles_there
from kagezou.locations import PRESET_FOLDERS, SHORTCUT_FOLDERS, STYLE_FOLDERS, studio_folders


@pytest.fixture
def folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, Path]:
    """A show's folder before the studio's, for everything."""
    show, studio = tmp_path / "show", tmp_path / "studio"
    for variable in (STYLE_FOLDERS, PRESET_FOLDERS, SHORTCUT_FOLDERS):
        monkeypatch.setenv(variable, f"{show}{os.pathsep}{os.pathsep} {studio} {os.pathsep}{show}")
    show.mkdir()
    studio.mkdir()
    return show, studio


def look(name: str, tall: float) -> Style:
    return Style(LocalName(name), tall, MappingProxyType({}))


def test_folders_are_parted_as_in_path(folders: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    assert studio_folders(STYLE_FOLDERS) == folders
    monkeypatch.setenv(STYLE_FOLDERS, "~/styles")
    assert studio_folders(STYLE_FOLDERS) == (Path.home() / "styles",)
    monkeypatch.delenv(STYLE_FOLDERS)
    assert studio_folders(STYLE_FOLDERS) == ()


def test_of_styles_with_one_name_the_nearest_counts(folders: tuple[Path, Path], tmp_path: Path) -> None:
    show, studio = folders
    own = tmp_path / "own"
    for folder, names in ((studio, ("Natural", "Dusk", "Noon")), (show, ("dusk", "Own")), (own, ("Own",))):
        for name in names:
            save_style(folder, look(name, {studio: 100.0, show: 200.0, own: 300.0}[folder]))
    found, problems = styles_there(own)
    assert problems == ()
    natural = [each for each in found if each.style.name.en == "Natural"]
    assert [(each.is_studio, each.is_own) for each in natural] == [(True, False)]
    tall = {each.style.name.en: each.style.figure_px for each in found if each.path.is_relative_to(tmp_path)}
    assert tall == {"Natural": 100.0, "dusk": 200.0, "Noon": 100.0, "Own": 300.0}
    assert len(found) == len(bundled_styles()) + 3
    assert named_style("DUSK", found).figure_px == 200.0
    with pytest.raises(UsageProblem, match="did you mean Noon"):
        named_style("Nooon", found)


def test_what_cannot_be_read_is_said_and_hides_nothing(
    folders: tuple[Path, Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    show, _ = folders
    (show / "broken.json").write_text("{")
    save_preset(show, "to the lab", ExportChoices(depth=16))
    for variable in (STYLE_FOLDERS, PRESET_FOLDERS, SHORTCUT_FOLDERS):
        monkeypatch.setenv(variable, f"{show}{os.pathsep}{tmp_path / 'nowhere'}")
    styles, style_problems = styles_there(tmp_path / "own")
    assert len(styles) == len(bundled_styles())
    presets, preset_problems = presets_there(tmp_path / "own")
    assert [each.name for each in presets] == ["to the lab"]
    sets, set_problems = key_sets_there()
    assert len(sets) == len(bundled_key_sets())
    for problems, variable in (
        (style_problems, STYLE_FOLDERS),
        (preset_problems, PRESET_FOLDERS),
        (set_problems, SHORTCUT_FOLDERS),
    ):
        said = [str(each) for each in problems]
        assert any("broken.json" in each for each in said)
        assert f"{variable}: {tmp_path / 'nowhere'}: it does not exist" in said


def test_presets_of_the_studio_stay_below_the_users(folders: tuple[Path, Path], tmp_path: Path) -> None:
    show, studio = folders
    save_preset(studio, "comp", ExportChoices(depth=8))
    save_preset(studio, "look", ExportChoices(composite=True))
    save_preset(show, "comp", ExportChoices(depth=16))
    save_preset(tmp_path / "own", "look", ExportChoices(united=True))
    found, problems = presets_there(tmp_path / "own")
    assert problems == ()
    assert [(each.name, each.is_studio, each.choices.depth) for each in found] == [
        ("comp", True, 16),
        ("look", False, 8),
    ]


def test_shortcuts_of_the_studio_take_the_place_of_a_set_or_come_after_it(folders: tuple[Path, Path]) -> None:
    show, studio = folders
    first, second, *_ = bundled_key_sets()
    save_key_set(studio / f"{second.code}.json", KeySet("", LocalName("Ours"), MappingProxyType({"undo": ("F5",)})))
    save_key_set(show / "night.json", KeySet("", LocalName("Night"), MappingProxyType({"undo": ("F6",)})))
    found, problems = key_sets_there()
    assert problems == ()
    assert found[0] == first
    assert (found[1].name.en, found[1].is_studio) == ("Ours", True)
    assert (found[-1].code, found[-1].keys["undo"]) == ("night", ("F6",))
