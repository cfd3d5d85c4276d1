"""What folders and files hold, before any of it is taken: characters with their drawings, and what is doubtful."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.errors import InputProblem
from kagezou.importing.cels_of_files import cels_of
from kagezou.importing.new_cels import CharacterSource, left_out_note, printable
from kagezou.importing.understood import numbers_text
from kagezou.io.files.faults import input_problem, shown
from kagezou.io.files.spellings import on_disk
from kagezou.io.images.parts import exr_layer_names, is_exr
from kagezou.io.images.sequences import Found, find_sequences, sequences_among
from kagezou.io.images.sequences import Sequence as FileSequence
from kagezou.io.oca.reading import oca_file, read_oca
from kagezou.io.pixels.signatures import is_picture, is_psd
from kagezou.io.project.paths import absolute
from kagezou.message import Message
from kagezou.picture_source import PictureSource


@dataclass(frozen=True, slots=True)
class FoundCharacter:
    """A character that could be taken.

    Parameters
    ----------
    source
        What brings it, with its name.
    count
        How many drawings it has; 0 where only reading the file would tell.
    numbers
        Their numbers, short; empty where they have none.
    first_name, last_name
        What its first and its last file are called.
    picture
        Its first drawing.
    notes
        What is doubtful about it.
    layers
        Of OpenEXR files with several layers that can be a picture: their names, the one that is used by itself first.
    """

    source: CharacterSource
    count: int
    numbers: str
    first_name: str
    last_name: str
    picture: PictureSource
    notes: tuple[Message, ...] = ()
    layers: tuple[str, ...] = ()

    @property
    def is_clear(self) -> bool:
        """Whether there is no doubt about it and nothing to choose."""
        return not self.notes and not self.layers

    @property
    def name(self) -> str:
        """What the layer is to be called."""
        return self.source.name or printable(self.source.path.stem)


@dataclass(frozen=True, slots=True)
class FoundCharacters:
    """Everything that could be taken, from the lowest up, and what is to be said of it as a whole."""

    characters: tuple[FoundCharacter, ...]
    notes: tuple[Message, ...] = ()

    @property
    def is_clear(self) -> bool:
        """Whether there is one character and no doubt."""
        return len(self.characters) == 1 and not self.notes and self.characters[0].is_clear

    @property
    def sources(self) -> tuple[CharacterSource, ...]:
        """What brings all of it."""
        return tuple(each.source for each in self.characters)


def found_characters(sources: Iterable[CharacterSource], pictures: Sequence[Path] = ()) -> FoundCharacters:
    """Return the characters of folders, patterns, stills and files of layers, and those among chosen pictures.

    Raises
    ------
    InputProblem
        There is nothing to be found.
    """
    found: list[FoundCharacter] = []
    notes: list[Message] = []
    for source in sources:
        path = on_disk(absolute(source.path))
        if is_psd(path) and path.is_file():
            name = shown(Path(path.name))
            found.append(FoundCharacter(replace(source, path=path), 0, "", name, name, path))
            continue
        if (document := oca_file(path)) is not None:
            found.append(_of_oca(document, replace(source, path=path)))
            continue
        held = find_sequences(path)
        own = path.name if path.is_dir() and len(held.sequences) == 1 else ""
        found += [_of_sequence(each, replace(source, path=path), own) for each in held.sequences]
        notes += _general(held, path)
    if pictures:
        among = sequences_among(pictures)
        found += [_of_sequence(each, CharacterSource(None, each.files[0].path.parent), "") for each in among.sequences]
        notes += _general(among, pictures[0].parent)
    return FoundCharacters(tuple(found), tuple(notes))


def whole_of(picture: Path) -> FoundCharacters:
    """Return the sequence in its folder that a picture belongs to; the picture alone where it is a still.

    A PSD file is never one of a sequence: its number is rather that of the cut, and the cels are in it.

    Raises
    ------
    InputProblem
        The picture cannot be found.
    """
    if not is_psd(picture):
        for sequence in sequences_among(_beside(on_disk(absolute(picture)))).sequences:
            if any(file.path.name == picture.name for file in sequence.files) and len(sequence.files) > 1:
                return FoundCharacters((_of_sequence(sequence, CharacterSource(None, picture.parent), ""),))
    return found_characters([CharacterSource(None, picture)])


def _of_oca(document: Path, source: CharacterSource) -> FoundCharacter:
    """Return the layers of a document of Open Cel Animation as one find, as those of a PSD file are."""
    files = [frame.file for layer in read_oca(document).layers for frame in layer.frames if frame.file is not None]
    name = shown(Path(document.name))
    return FoundCharacter(source, 0, "", name, name, files[0] if files else document)


def _beside(picture: Path) -> list[Path]:
    try:
        return [each for each in picture.parent.iterdir() if is_picture(each) and not is_psd(each) and each.is_file()]
    except OSError as error:
        raise input_problem(picture, error) from error


def _of_sequence(sequence: FileSequence, source: CharacterSource, own_name: str) -> FoundCharacter:
    drawings = cels_of(sequence).drawings
    name = source.name or printable(own_name or sequence.name)
    first, last = (shown(Path(drawing.path.name)) for drawing in (drawings[0], drawings[-1]))
    numbers = numbers_text([each.name for each in drawings]) if sequence.files[0].number is not None else ""
    whole = replace(source, name=name, drawings=sequence)
    layers = _layers_of(drawings[0].path) if source.layer is None else ()
    return FoundCharacter(whole, len(drawings), numbers, first, last, drawings[0].source, sequence.notes, layers)


def _layers_of(path: Path) -> tuple[str, ...]:
    """Return the layers that one may choose among; none where there is one alone, or the file cannot be read."""
    if not is_exr(path):
        return ()
    try:
        names = exr_layer_names(path)
    except InputProblem:  # told when it is brought
        return ()
    return names if len(names) > 1 else ()


def _general(found: Found, path: Path) -> list[Message]:
    """Return what is said of a source as a whole, without what is said of its characters."""
    of_one = {note for sequence in found.sequences for note in sequence.notes}
    notes = [note for note in found.notes if note not in of_one]
    if found.left_out:
        notes.append(left_out_note(path, (shown(Path(each.name)) for each in found.left_out)))
    return notes
