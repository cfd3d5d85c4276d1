"""Which cuts there are in what a person names."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from kagezou.batch.cuts import FoundCuts, found_cuts
from kagezou.errors import InputProblem, UsageProblem
from kagezou.importing.cut_files import cut_files
from tests.batch.cut_folders import drawings, picture, timesheet
from tests.psd_files import Leaf, block, write_psd


@pytest.fixture
def out(tmp_path: Path) -> Path:
    return tmp_path / "out"


def named(found: FoundCuts, root: Path) -> dict[str, str]:
    return {cut.name: cut.path.relative_to(root).as_posix() for cut in found.cuts}


def layered(path: Path) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    write_psd(path, [Leaf("A1", block(8, 8), (4, 4))])
    return path


def test_a_folder_of_cuts_of_every_kind(tmp_path: Path, out: Path) -> None:
    episode = tmp_path / "ep"
    drawings(episode / "c001" / "A")
    drawings(episode / "c002")
    layered(episode / "c003.psd")
    layered(episode / "c004.psd")
    timesheet(episode / "c004.xdts", {"A": [(1, 1)]})
    drawings(episode / "c005" / "A")
    timesheet(episode / "c005.xdts", {"A": [(1, 1)]})
    (episode / "c006").mkdir()
    picture(episode / "BG.png")
    (episode / ".hidden").mkdir()
    found = found_cuts([episode], out)
    assert named(found, episode) == {
        "c001": "c001",
        "c002": "c002",
        "c005": "c005",
        "c006": "c006",
        "c003": "c003.psd",
        "c004": "c004.psd",
    }
    assert [str(note) for note in found.notes] == [f"{episode}: beside cuts, and none itself: BG.png"]


@pytest.mark.parametrize(
    "made",
    [
        ["A", "B"],
        ["A", "BG"],
        ["."],
        ["hero", "BG"],
        [".", "c_ref/old"],
        ["c012_A", "c012_B"],
        ["_Cell/A"],
        ["cel/A", "cel/B"],
    ],
    ids=" ".join,
)
def test_folders_that_are_one_cut(tmp_path: Path, out: Path, made: list[str]) -> None:
    for name in made:
        drawings(tmp_path / "cut" / name)
    assert named(found_cuts([tmp_path / "cut"], out), tmp_path) == {"cut": "cut"}


@pytest.mark.parametrize(
    "made",
    [
        ["c001", "c002"],
        ["cut1", "cut2"],
        ["カット3", "カット12"],
        ["walk", "run"],
        ["s01_c012", "s01_c013"],
        ["walk/A", "run/B"],
        ["0012", "0013a"],
    ],
    ids=" ".join,
)
def test_folders_that_hold_cuts(tmp_path: Path, out: Path, made: list[str]) -> None:
    for name in made:
        drawings(tmp_path / "ep" / name)
    found = found_cuts([tmp_path / "ep"], out)
    assert sorted(cut.name for cut in found.cuts) == sorted(name.split("/")[0] for name in made)


def test_files_and_folders_can_be_named_one_by_one(tmp_path: Path, out: Path) -> None:
    psd = layered(tmp_path / "x" / "c1.psd")
    sheet = timesheet(tmp_path / "y" / "c2.xdts", {"A": [(1, 1)]})
    folder = drawings(tmp_path / "z" / "c3")
    assert [cut.path for cut in found_cuts([psd, sheet, folder, folder], out).cuts] == [psd, sheet, folder]


def test_cuts_of_one_name_are_told_apart_and_that_is_said(tmp_path: Path, out: Path) -> None:
    for episode in ("ep1", "EP2"):
        drawings(tmp_path / episode / "c001")
    drawings(tmp_path / "more" / "C001")
    drawings(tmp_path / "deep" / "more" / "c001")
    found = found_cuts([tmp_path / "ep1", tmp_path / "EP2", tmp_path / "more", tmp_path / "deep" / "more"], out)
    assert [cut.name for cut in found.cuts] == ["c001", "EP2_c001", "more_C001", "more_c001_2"]
    assert len(found.notes) == 3


def test_a_name_that_no_system_takes_is_made_one(tmp_path: Path, out: Path) -> None:
    drawings(tmp_path / "ep" / "c001 <?>")
    assert [cut.name for cut in found_cuts([tmp_path / "ep"], out).cuts] == ["c001 ___"]


def test_the_output_among_the_cuts_is_none_of_them(tmp_path: Path) -> None:
    for name in ("c001", "c002", "out/c001"):
        drawings(tmp_path / "ep" / name)
    assert len(found_cuts([tmp_path / "ep"], tmp_path / "ep" / "out").cuts) == 2
    assert len(found_cuts([tmp_path / "ep"], tmp_path / "ep" / "out" / "deeper").cuts) == 2


@pytest.mark.parametrize("mark", [".kagezou-frames.jsonl", "report.html"])
def test_an_output_of_before_is_no_cut_and_that_is_said(tmp_path: Path, out: Path, mark: str) -> None:
    drawings(tmp_path / "ep" / "c001")
    drawings(tmp_path / "ep" / "c001_shadows" / "A_shadow")
    (tmp_path / "ep" / "c001_shadows" / mark).touch()
    found = found_cuts([tmp_path / "ep"], out)
    assert [cut.name for cut in found.cuts] == ["c001"]
    assert "c001_shadows" in str(found.notes[0])


@pytest.mark.parametrize("output", ["ep/c001", "ep/c001/out", "ep", "ep/c001/A/x"])
def test_an_output_among_the_drawings_of_a_cut_is_refused(tmp_path: Path, output: str) -> None:
    drawings(tmp_path / "ep" / "c001" / "A")
    with pytest.raises(UsageProblem, match="among the drawings of this cut"):
        found_cuts([tmp_path / "ep" / "c001"], tmp_path / output)


def test_folders_of_cuts_are_not_looked_into_any_deeper_and_that_is_said(tmp_path: Path, out: Path) -> None:
    drawings(tmp_path / "show" / "ep01" / "c001")
    drawings(tmp_path / "show" / "c900")
    found = found_cuts([tmp_path / "show"], out)
    assert [cut.name for cut in found.cuts] == ["c900"]
    assert "name it itself" in str(found.notes[0])


def test_nothing_there_is_said(tmp_path: Path, out: Path) -> None:
    (tmp_path / "ep").mkdir()
    with pytest.raises(InputProblem, match="there is no cut in it"):
        found_cuts([tmp_path / "ep"], out)
    with pytest.raises(InputProblem, match="does not exist"):
        found_cuts([tmp_path / "gone"], out)


def test_a_folder_that_cannot_be_looked_into_is_a_cut_that_fails_by_itself(
    tmp_path: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("c001", "c002"):
        drawings(tmp_path / "ep" / name)
    listing = Path.iterdir

    def iterdir(path: Path) -> Iterator[Path]:
        if path.name == "c001":
            raise PermissionError(13, "Permission denied")
        return listing(path)

    monkeypatch.setattr(Path, "iterdir", iterdir)
    assert [cut.name for cut in found_cuts([tmp_path / "ep"], out).cuts] == ["c001", "c002"]
    with pytest.raises(InputProblem, match="c001"):
        cut_files(tmp_path / "ep" / "c001")
