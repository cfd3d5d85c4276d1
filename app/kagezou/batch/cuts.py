"""Which cuts there are: a folder is one, or holds folders, timesheets or files of layers that are cuts."""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from kagezou.batch.cut import Cut
from kagezou.batch.record import RECORD_NAME, REPORT_NAME
from kagezou.document.alike_names import folded
from kagezou.errors import InputProblem, UsageProblem
from kagezou.export.ledger import LEDGER_NAME
from kagezou.export.names import safe_names
from kagezou.importing.cut_listing import Listing, folders_in, holds_pictures, is_column_name, listed, plain
from kagezou.importing.new_cels import printable
from kagezou.importing.sheet_project import TIMESHEET_SUFFIXES
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.oca.reading import oca_file
from kagezou.io.project.paths import absolute
from kagezou.message import Message, first_names

_NUMBERED: Final = re.compile(r".*[0-9]{2,}[a-z]?|.*(?:cut|カット|c|sc|shot)[_\-. ]*[0-9]+[a-z]?")
"""A folder that is called so holds a cut rather than a column of one."""


@dataclass(frozen=True, slots=True)
class FoundCuts:
    """The cuts, in the order in which they were found, and what is to be said of what lies beside them."""

    cuts: tuple[Cut, ...]
    notes: tuple[Message, ...] = ()


def found_cuts(paths: Sequence[Path], output: Path) -> FoundCuts:
    """Return the cuts in folders and files, each under a name of its own.

    Parameters
    ----------
    paths
        Each is a cut, or a folder of cuts, which is not looked into any deeper.
    output
        Where they will be made; what lies there is no cut.

    Raises
    ------
    InputProblem
        One of the paths is not there, or there is no cut at all.
    UsageProblem
        The output would lie in a cut, or a cut in its own output.
    """
    output = absolute(output)
    places: list[Path] = []
    notes: list[Message] = []
    for path in dict.fromkeys(on_disk(absolute(each)) for each in paths):
        if not path.exists():
            raise input_problem(path, Message("it does not exist"))
        inside, said = _cuts_at(path, output)
        places += inside
        notes += said
    places = list(dict.fromkeys(places))
    if not places:
        names = first_names(shown(each) for each in paths)
        raise InputProblem(Message("{names}: there is no cut in it", names=names))
    cuts = tuple(_named(places, notes))
    for cut in cuts:
        _check_apart(cut, output)
    return FoundCuts(cuts, tuple(notes))


def is_cut(listing: Listing) -> bool:
    """Return whether a folder is one cut, not a folder of cuts."""
    files = (*listing.sheets, *listing.layered)
    if listing.columns or (listing.layered and all(is_column_name(each.stem) for each in listing.layered)):
        return True
    if len(listing.sheets) > 1 or len(listing.layered) > 1 or any(map(_is_called_a_cut, listing.folders)):
        return False
    if {folded(each.stem) for each in files} & {folded(each.name) for each in listing.folders}:
        return False
    if listing.runs:
        return True
    if any(_is_deep(each) for each in listing.folders):
        return False
    if files:
        return True
    filled = [each for each in listing.folders if holds_pictures(each)]
    return bool(listing.pictures if not filled else listing.backgrounds)


def _cuts_at(path: Path, output: Path) -> tuple[list[Path], list[Message]]:
    if not path.is_dir() or oca_file(path) is not None:
        return [path], []
    listing = listed(path)
    if is_cut(listing):
        return [path], []
    found = list(_below(listing, output))
    folders = [each for each in found if each.is_dir()]
    nested = [each for each in folders if any(map(_is_called_a_cut, folders_in(each))) and not is_cut(listed(each))]
    notes = [
        Message("{path}: a folder of cuts in a folder of cuts is not looked into; name it itself", path=shown(each))
        for each in nested
    ]
    outputs = [each for each in listing.folders if _is_output(each)]
    # Beside timesheets they are the drawings and backgrounds of these.
    pictures = () if any(each in listing.sheets for each in found) else (*listing.backgrounds, *listing.pictures)
    left = [each.name for each in (*pictures, *outputs)]
    if left:
        names = first_names(shown(Path(each)) for each in left)
        notes.append(Message("{path}: beside cuts, and none itself: {names}", path=shown(path), names=names))
    return [each for each in found if each not in nested], notes


def _below(listing: Listing, output: Path) -> Iterator[Path]:
    """Yield folders, timesheets and layered files, of those of one name the first."""
    seen: set[str] = set()
    for each in (*listing.folders, *listing.sheets, *listing.layered):
        if each == output or each in output.parents or _is_output(each):
            continue
        name = folded(_title(each))
        if name not in seen:
            seen.add(name)
            yield each if each not in listing.sheets else _with_layers(each, listing)


def _is_output(path: Path) -> bool:
    """Return whether the program itself wrote what lies in a folder."""
    return any((path / name).is_file() for name in (LEDGER_NAME, RECORD_NAME, REPORT_NAME))


def _with_layers(sheet: Path, listing: Listing) -> Path:
    """Return the file of layers of the name of a timesheet, which it times; else the timesheet."""
    return next((each for each in listing.layered if folded(_title(each)) == folded(sheet.stem)), sheet)


def _title(path: Path) -> str:
    return path.name if path.is_dir() and path.suffix.lower() != ".oca" else path.stem


def _is_called_a_cut(folder: Path) -> bool:
    return _NUMBERED.fullmatch(plain(folder.name)) is not None


def _is_deep(folder: Path) -> bool:
    """Return whether a folder holds a timesheet, a file of layers, or folders of pictures, as that of a cut does."""
    try:
        entries = list(folder.iterdir())
    except OSError:
        return False
    return any(
        each.suffix.lower() in TIMESHEET_SUFFIXES or oca_file(each) is not None or holds_pictures(each)
        for each in entries
    )


def _named(places: Iterable[Path], notes: list[Message]) -> Iterator[Cut]:
    """Yield cuts; one whose name was there already is called like its folder as well."""
    names: dict[Path, str] = {}
    for place in places:
        name = printable(_title(place))
        if folded(name) in map(folded, names.values()):
            name = printable(f"{place.parent.name}_{name}")
            number = 2
            while folded(name) in map(folded, names.values()):
                name, number = printable(f"{place.parent.name}_{_title(place)}_{number}"), number + 1
            notes.append(
                Message("{path}: there is a cut of its name, so it is made as {name}", path=shown(place), name=name)
            )
        names[place] = name
    safe = safe_names(names.values())
    for place, name in names.items():
        yield Cut(safe[name], place)


def _check_apart(cut: Cut, output: Path) -> None:
    """Raise UsageProblem where making a cut would write among its drawings."""
    own = output / cut.name
    folder = cut.path if cut.path.is_dir() else None
    if folder is not None and (folder in (own, output) or folder in output.parents or own in folder.parents):
        raise UsageProblem(
            Message(
                "{path}: the output would lie among the drawings of this cut; give it another folder",
                path=shown(folder),
            )
        )
