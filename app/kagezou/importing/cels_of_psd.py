"""From PSD files to cels: its groups are characters, its numbered layers their drawings."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from kagezou.document.model import Cels, Drawing, Exposure
from kagezou.errors import InputProblem
from kagezou.extras import PSD
from kagezou.importing.cel_sizes import measured_cels
from kagezou.importing.file_notes import said_once
from kagezou.importing.new_cels import CharacterSource, Held, NewCels, left_out_note, printable
from kagezou.importing.painted import notes_on_first_drawings
from kagezou.importing.paper import on_found_paper
from kagezou.importing.progress import Progress
from kagezou.importing.psd_characters import PsdCel, PsdCharacter, PsdCharacters, characters_in
from kagezou.io.files.faults import shown
from kagezou.io.images.reading import read_matte
from kagezou.io.psd.file import psd_notes, psd_tree
from kagezou.io.psd.tree import PsdTree
from kagezou.io.psd.undrawn import drawn_by_extra
from kagezou.message import Message, first_names
from kagezou.picture_source import PicturePart


def held_by_psd(source: CharacterSource, path: Path, progress: Progress) -> Held:
    """Return the layers that the PSD file at ``path`` holds; raises as `cels_of_files.held_by` does."""
    tree = psd_tree(path)
    if not tree.layers:
        name = source.name or printable(path.stem)
        cels = Cels((Drawing(printable(path.stem), path),), (Exposure(1, 0),))
        measured = measured_cels(name, cels.drawings, progress)
        cels, on_paper = on_found_paper(name, replace(cels, drawings=measured.drawings))
        return Held(
            [
                NewCels(
                    name, cels, measured.size_px, 1, (*measured.notes, *on_paper, *notes_on_first_drawings(name, cels))
                )
            ],
            list(said_once(name, [(path, psd_notes(path))])),
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
    notes = [
        *said_once(path.stem, [(path, psd_notes(path))]),
        *_joined_in(path, layers),
        *_left_out_of(path, cast),
        *_laid_simply(path, tree, cast),
    ]
    return Held(layers, notes, tuple(PicturePart(path, node.address) for node in backgrounds))


def _joined_in(path: Path, layers: Iterable[NewCels]) -> list[Message]:
    """Return what is said about layers that were taken as parts of one figure."""
    figures = dict.fromkeys(layer.joins for layer in layers if layer.joins is not None)
    return [
        Message(
            "{path}: one figure with one shadow: {names}",
            path=shown(path),
            names=first_names([figure, *(layer.name for layer in layers if layer.joins == figure)]),
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
                "{name}: these are not drawn without a part that is missing ({how}): {by_extra}",
                name=name,
                how=PSD.how,
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
                names=first_names(node.name for node in cast.hidden),
            )
        )
    empty = [node for node in cast.empty if not node.is_adjustment]
    if empty:
        notes.append(
            Message(
                "{path}: left out, as they are empty: {names}",
                path=shown(path),
                names=first_names(node.name for node in empty),
            )
        )
    if cast.unnumbered:
        notes.append(left_out_note(path, (node.name for node in cast.unnumbered)))
    return [*notes, *said_once(path.stem, [(path, cast.notes)])]


def _laid_simply(path: Path, tree: PsdTree, cast: PsdCharacters) -> list[Message]:
    """Return what is said about colours that a drawing has in the file by what lies around it, and not here."""
    every = {node.address: node for top in tree.layers for node in (top, *top.below())}
    cels = [cel.node for character in cast.characters for cel in character.cels]
    inside = {node.address for cel in cels for node in cel.below()}
    adjusting = [
        node.name
        for node in every.values()
        if node.is_adjustment and node.is_visible and not node.is_clipped and node.address not in inside
    ]
    around = dict.fromkeys(each for cel in cels for each in _with_groups(cel.address))
    laid = [node for address in around if (node := every[address]).blend]
    notes = []
    if adjusting:
        notes.append(
            Message(
                "{path}: adjustment layers over drawings are not used: {names}",
                path=shown(path),
                names=first_names(adjusting),
            )
        )
    if laid:
        names = first_names(f"{node.name} ({node.blend})" for node in laid)
        notes.append(
            Message("{path}: these lie simply over what is below them here: {names}", path=shown(path), names=names)
        )
    return notes


def _with_groups(address: str) -> Iterator[str]:
    """Yield the addresses of the groups around a layer, the outermost first, and its own."""
    parts = address.split("/")
    for end in range(1, len(parts) + 1):
        yield "/".join(parts[:end])
