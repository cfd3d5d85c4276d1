"""Names that Unicode writes in two ways are found in either."""

import unicodedata
from pathlib import Path

import pytest

from kagezou.io.files.spellings import Listings, on_disk


def nfd(text: str) -> str:
    return unicodedata.normalize("NFD", text)


def nfc(text: str) -> str:
    return unicodedata.normalize("NFC", text)


@pytest.mark.parametrize("kept", [nfc, nfd])
def test_each_folder_on_the_way_may_be_spelled_otherwise(tmp_path: Path, kept: object) -> None:
    spell, other = (nfc, nfd) if kept is nfc else (nfd, nfc)
    there = tmp_path / spell("カガ") / "plain" / spell("é_0001.png")
    there.parent.mkdir(parents=True)
    there.touch()
    assert on_disk(there) == there
    assert on_disk(tmp_path / other("カガ") / "plain" / other("é_0001.png")).samefile(there)
    listings: Listings = {}
    on_disk(tmp_path / other("カガ") / "plain" / other("é_0001.png"), listings)
    assert on_disk(tmp_path / other("カガ") / "plain" / other("é_0001.png"), listings).samefile(there)


def test_what_is_not_there_stays_as_it_is_written(tmp_path: Path) -> None:
    for name in ("plain", nfd("ガ"), f"{nfd('ガ')}/{nfd('パ')}.png"):
        assert on_disk(tmp_path / name) == tmp_path / name
    (tmp_path / nfc("ガ")).touch()
    assert on_disk(tmp_path / nfd("ガ") / nfd("パ")) == tmp_path / nfd("ガ") / nfd("パ")
    assert on_disk(Path(nfd("ガ/パ"))) == Path(nfd("ガ/パ"))
