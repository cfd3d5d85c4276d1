"""Every file of the corpus is understood as its table says, and says what of it is not used."""

import json
from pathlib import Path
from typing import Any

import pytest

from kagezou.errors import Problem
from kagezou.importing.inspection import inspected

HERE = Path(__file__).parent
TABLE: dict[str, dict[str, Any]] = json.loads((HERE / "table.json").read_text(encoding="utf-8"))
_OF_FOLDERS = "names"


def entries() -> set[str]:
    """Return every folder of names and every other file that is read."""
    folders = {f"{_OF_FOLDERS}/{each.name}" for each in (HERE / _OF_FOLDERS).iterdir()}
    files = {
        f"{folder.name}/{each.name}"
        for folder in HERE.iterdir()
        if folder.is_dir() and folder.name not in {_OF_FOLDERS, "__pycache__"}
        for each in folder.iterdir()
        if each.is_file()
    }
    return folders | files


def lacking(expected: Any, found: Any, where: str = "") -> list[str]:
    """Return where ``found`` does not hold what is expected; of an object only the expected members count."""
    if isinstance(expected, dict) and isinstance(found, dict):
        return [
            each
            for name, part in expected.items()
            for each in lacking(part, found.get(name, "nothing"), f"{where}.{name}")
        ]
    if isinstance(expected, list) and isinstance(found, list) and len(expected) == len(found):
        pairs = enumerate(zip(expected, found, strict=True))
        return [each for index, (part, own) in pairs for each in lacking(part, own, f"{where}[{index}]")]
    if isinstance(expected, float) and isinstance(found, float):
        return [] if found == pytest.approx(expected, abs=1e-3) else [f"{where}: {found!r}, not {expected!r}"]
    return [] if expected == found else [f"{where}: {found!r}, not {expected!r}"]


def test_nothing_is_without_an_expectation() -> None:
    assert entries() == set(TABLE)


@pytest.mark.parametrize("name", sorted(TABLE))
def test_a_file_is_understood(name: str) -> None:
    row = TABLE[name]
    path = HERE / name
    if "refused" in row:
        with pytest.raises(Problem) as caught:
            inspected(path)
        assert str(caught.value) == f"{path}: {row['refused']}"
        return
    found = inspected(path)
    facts = json.loads(json.dumps({"kind": found.kind, **found.facts}))
    assert lacking(row["facts"], facts) == []
    notes = [str(note).replace(str(HERE), "") for note in found.notes]
    for words in row["notes"]:
        assert any(words in note for note in notes), notes
    assert len(notes) == len(row["notes"]), notes
