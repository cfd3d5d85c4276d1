"""Other drawings for a layer: its keys stay, and its exposures where the drawings are the same ones by number."""

from dataclasses import replace

from kagezou.document.edits import set_canvas
from kagezou.document.model import Cels, Document, Drawing, Exposure
from kagezou.document.paper import on_paper, paper_of
from kagezou.errors import UsageProblem
from kagezou.importing.imported import Imported
from kagezou.importing.staging import Brought
from kagezou.io.names.runs import number_in
from kagezou.message import Message, first_names


def replaced(document: Document, layer_id: str, read: Brought) -> Imported:
    """Return the document with other drawings in a layer.

    Parameters
    ----------
    document
        The document.
    layer_id
        The layer; its name, keys, marks and what it joins stay.
    read
        What was brought for it; the first character counts.

    Raises
    ------
    UsageProblem
        Nothing was brought.
    """
    if not read.characters:
        raise UsageProblem(Message("there are no drawings that could take the place of those of the layer"))
    layer, new, seen = document.layer(layer_id), read.characters[0], read.figures_seen[0]
    exposures = _exposures(layer.cels, new.cels)
    notes = [*read.notes, *new.notes, *(note for note in seen.notes if note not in new.notes)]
    if exposures is None:
        notes.append(
            Message("{name}: these are other drawings, so they are exposed as their numbers say", name=layer.name)
        )
    if len(read.characters) > 1:
        others = first_names(each.name for each in read.characters[1:])
        notes.append(Message("{name}: a layer holds one character; left out: {names}", name=layer.name, names=others))
    cels = new.cels if exposures is None else replace(new.cels, exposures=exposures)
    figure = seen.figure.on(document.canvas.box).box if seen.figure else document.canvas.box
    changed = replace(layer, cels=on_paper(cels, paper_of(layer)), figure=figure)
    layers = tuple(changed if each.id == layer_id else each for each in document.layers)
    last = max((exposure.frame for exposure in cels.exposures), default=1)
    longer = replace(document.canvas, length_frames=max(document.canvas.length_frames, last))
    return Imported(set_canvas(replace(document, layers=layers), longer), tuple(notes), (layer_id,))


def _exposures(before: Cels, after: Cels) -> tuple[Exposure, ...] | None:
    """Return the exposures there are with the new drawings of the same names or numbers; None where one is missing."""
    by_key = {_key(drawing): index for index, drawing in reversed(list(enumerate(after.drawings)))}
    used = {exposure.drawing for exposure in before.exposures if exposure.drawing is not None}
    places = {index: by_key.get(_key(before.drawings[index])) for index in used}
    if None in places.values():
        if len(before.drawings) != len(after.drawings):
            return None
        places = {index: index for index in used}
    return tuple(
        exposure if exposure.drawing is None else replace(exposure, drawing=places[exposure.drawing])
        for exposure in before.exposures
    )


def _key(drawing: Drawing) -> object:
    """Return what makes a drawing the same one in another folder: its number, else its name."""
    return number_in(drawing.name) or drawing.name
