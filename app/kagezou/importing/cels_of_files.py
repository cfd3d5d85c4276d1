"""From picture files to cels: which drawings a source holds, when each is exposed, how large they are."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from kagezou.animation.frames import format_frames
from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.errors import InputProblem
from kagezou.importing.cel_sizes import measured_cels
from kagezou.importing.file_notes import said_once
from kagezou.importing.painted import notes_on_painted_shadows
from kagezou.importing.paper import on_found_paper
from kagezou.importing.progress import LoadPhase, Progress, no_progress
from kagezou.importing.psd_characters import PsdCel, PsdCharacter, PsdCharacters, characters_in
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import read_matte
from kagezou.io.images.sequences import NumberedFile, Sequence, find_sequences
from kagezou.io.pixels.signatures import is_psd
from kagezou.io.project.paths import absolute
from kagezou.io.psd.file import psd_tree
from kagezou.io.psd.undrawn import drawn_by_extra
from kagezou.message import Message
from kagezou.picture_source import PicturePart

MAX_NAME_CHARACTERS = 200
_SHOWN_NAMES = 3


@dataclass(frozen=True, slots=True)
class CharacterSource:
    """A character someone brings: a folder, a picture, a PSD file or a pattern ``walk_#.png``, and perhaps its name.

    Where a timesheet says when each drawing is seen, numbers that no file has are nothing to speak of. A source that
    joins a character is a part of its figure: an arm, a held thing.
    """

    name: str | None
    path: Path
    is_timed: bool = False
    joins: str | None = None


@dataclass(frozen=True, slots=True)
class NewCels:
    """The cels of a layer to be.

    Parameters
    ----------
    name
        What the layer is to be called.
    cels
        Its drawings, with absolute paths, and exposures.
    size_px
        The largest width and the largest height among its drawings.
    length_frames
        Up to the last exposure; 1 for a still.
    notes
        What is odd about the files, one sentence each.
    joins
        The name of the layer whose figure it is a part of; None for a figure of its own.
    """

    name: str
    cels: Cels
    size_px: tuple[int, int]
    length_frames: int
    notes: tuple[Message, ...]
    joins: str | None = None


@dataclass(frozen=True, slots=True)
class Held:
    """What a source holds.

    Parameters
    ----------
    layers
        From the lowest up.
    notes
        About the source as a whole.
    backgrounds
        Opaque pictures in it that are named like a background.
    """

    layers: list[NewCels]
    notes: list[Message]
    backgrounds: tuple[PicturePart, ...] = ()


def held_by(source: CharacterSource, progress: Progress = no_progress) -> Held:
    """Return the layers that a source holds, and notes about the source as a whole.

    Raises
    ------
    InputProblem
        There is nothing to be found, or none of the drawings of a layer can be opened.
    """
    path = absolute(source.path)
    progress(LoadPhase.FINDING, 0, 0)
    if is_psd(path) and path.is_file():
        return _joining(source, _held_by_psd(source, path, progress))
    found = find_sequences(path)
    notes = list(said_once(source.name or printable(path.stem), [(path, found.notes)]))
    if found.left_out:
        notes.append(_left_out(path, (shown(Path(each.name)) for each in found.left_out)))
    if len(found.sequences) == 1:
        only = found.sequences[0]
        own = path.name if path.is_dir() else only.name
        return _joining(source, Held([_new_cels(source.name or printable(own), only, source, progress)], notes))
    head = f"{source.name} " if source.name else ""
    layers = [_new_cels(head + printable(each.name), each, source, progress) for each in found.sequences]
    return _joining(source, Held(layers, notes))


def _joining(source: CharacterSource, held: Held) -> Held:
    """Return what a source holds as parts of the figure that it joins."""
    if source.joins is None:
        return held
    return replace(held, layers=[replace(layer, joins=source.joins) for layer in held.layers])


def _held_by_psd(source: CharacterSource, path: Path, progress: Progress) -> Held:
    tree = psd_tree(path)
    if not tree.layers:
        name = source.name or printable(path.stem)
        cels = Cels((Drawing(printable(path.stem), path),), (Exposure(1, 0),))
        measured = measured_cels(name, cels.drawings, progress)
        cels, on_paper = on_found_paper(name, replace(cels, drawings=measured.drawings))
        return Held(
            [
                NewCels(
                    name, cels, measured.size_px, 1, (*measured.notes, *on_paper, *notes_on_painted_shadows(name, cels))
                )
            ],
            list(said_once(name, [(path, tree.notes)])),
        )
    cast = characters_in(tree, path.stem)
    backgrounds = [node for node in cast.backgrounds if _is_opaque(PicturePart(path, node.address))]
    drawn = [node for node in cast.backgrounds if node not in backgrounds]
    characters = (*(PsdCharacter(each.name, (PsdCel(each.name, each),)) for each in drawn), *cast.characters)
    if not characters and not backgrounds:
        raise InputProblem(Message("{path}: every layer in it is hidden or empty", path=shown(path)))
    head = f"{source.name} " if source.name else ""
    size = (tree.width_px, tree.height_px)
    names = [head + printable(each.name) for each in characters]
    if source.name and len(names) == 1:
        names = [source.name]
    layers = [
        replace(_psd_cels(name, each, path, size), joins=each.joins and head + printable(each.joins))
        for name, each in zip(names, characters, strict=True)
    ]
    notes = [*said_once(path.stem, [(path, tree.notes)]), *_joined_in(path, layers), *_left_out_of(path, cast)]
    return Held(layers, notes, tuple(PicturePart(path, node.address) for node in backgrounds))


def _joined_in(path: Path, layers: Iterable[NewCels]) -> list[Message]:
    """Return what is said about layers that were taken as parts of one figure."""
    figures = dict.fromkeys(layer.joins for layer in layers if layer.joins is not None)
    return [
        Message(
            "{path}: one figure with one shadow: {names}",
            path=shown(path),
            names=_some([figure, *(layer.name for layer in layers if layer.joins == figure)]),
        )
        for figure in figures
    ]


def _psd_cels(name: str, character: PsdCharacter, path: Path, size: tuple[int, int]) -> NewCels:
    """Return the cels of a character in number order, on ones."""
    drawings = tuple(Drawing(printable(cel.name), path, cel.node.address, size) for cel in character.cels)
    cels = Cels(drawings, tuple(Exposure(index + 1, index) for index in range(len(drawings))))
    nodes = (each for cel in character.cels for each in (cel.node, *cel.node.below()))
    undrawn = dict.fromkeys(effect for node in nodes for effect in node.undrawn)
    return NewCels(name, cels, size, len(drawings), tuple(_undrawn_notes(name, tuple(undrawn))))


def _undrawn_notes(name: str, undrawn: tuple[str, ...]) -> list[Message]:
    by_extra = drawn_by_extra(undrawn)
    never = [each for each in undrawn if each not in by_extra]
    notes = []
    if never:
        notes.append(Message("{name}: these are not drawn: {never}", name=name, never=", ".join(never)))
    if by_extra:
        notes.append(
            Message(
                "{name}: these are drawn only after pip install 'kagezou[psd]': {by_extra}",
                name=name,
                by_extra=", ".join(by_extra),
            )
        )
    return notes


def _is_opaque(part: PicturePart) -> bool:
    return read_matte(part).is_full


def _left_out_of(path: Path, cast: PsdCharacters) -> list[Message]:
    notes = []
    if cast.hidden:
        notes.append(
            Message(
                "{path}: left out, as they are hidden: {names}",
                path=shown(path),
                names=_some(node.name for node in cast.hidden),
            )
        )
    if cast.empty:
        notes.append(
            Message(
                "{path}: left out, as they are empty: {names}",
                path=shown(path),
                names=_some(node.name for node in cast.empty),
            )
        )
    if cast.unnumbered:
        notes.append(_left_out(path, (node.name for node in cast.unnumbered)))
    return notes


def printable(name: str) -> str:
    """Return a file's or folder's name as one that a layer may have."""
    text = "".join(character if character.isprintable() else "_" for character in name).strip()
    return text[:MAX_NAME_CHARACTERS] or "Character"


def _left_out(path: Path, names: Iterable[str]) -> Message:
    return Message("{path}: left out, as they have no number: {names}", path=shown(path), names=_some(names))


def _some(names: Iterable[str]) -> str:
    known = list(names)
    return ", ".join(known[:_SHOWN_NAMES]) + (", …" if len(known) > _SHOWN_NAMES else "")


def _new_cels(name: str, sequence: Sequence, source: CharacterSource, progress: Progress) -> NewCels:
    cels = cels_of(sequence)
    measured = measured_cels(name, cels.drawings, progress)
    cels, on_paper = on_found_paper(name, replace(cels, drawings=measured.drawings))
    gaps = () if source.is_timed else gap_notes(name, sequence)
    last = cels.exposures[-1].frame
    return NewCels(
        name, cels, measured.size_px, last, (*gaps, *measured.notes, *on_paper, *notes_on_painted_shadows(name, cels))
    )


def cels_of(sequence: Sequence) -> Cels:
    """Return numbered pictures as drawings, exposed as their numbers say."""
    return Cels(tuple(_drawing(file) for file in sequence.files), _exposures(sequence.files))


def gap_notes(name: str, sequence: Sequence) -> tuple[Message, ...]:
    """Return what is to be said about numbers that no file has."""
    if not sequence.gaps:
        return ()
    gaps = format_frames(sequence.gaps)
    return (Message("{name}: missing {gaps}; the drawing before is held", name=name, gaps=gaps),)


def _drawing(file: NumberedFile) -> Drawing:
    name = file.path.stem if file.number is None else f"{file.number}{file.suffix}"
    return Drawing(printable(name), file.path)


def _exposures(files: Iterable[NumberedFile]) -> tuple[Exposure, ...]:
    """Return one exposure a drawing: the first number on frame 1, the others as far behind as their numbers say.

    A number that is there twice (12 and 12a) takes one frame more, so that no drawing is lost.
    """
    exposures: list[Exposure] = []
    numbers: list[int] = []
    inserted = 0
    for index, file in enumerate(files):
        number = file.number or 0
        inserted += number in numbers[-1:]
        numbers.append(number)
        exposures.append(Exposure(number - numbers[0] + 1 + inserted, index))
    return tuple(exposures)
