"""The paper of a layer's drawings: which white is clear where they have no alpha."""

from dataclasses import replace

from kagezou.document.model import Cels, Document, Layer
from kagezou.errors import UsageProblem
from kagezou.message import Message
from kagezou.picture_source import Paper


def paper_of(layer: Layer) -> Paper:
    """Return the paper of all drawings of a layer."""
    return layer.cels.drawings[0].paper if layer.cels.drawings else Paper.WHITE


def typed_paper(text: object) -> Paper:
    """Return a paper by its name.

    Raises
    ------
    UsageProblem
        There is none of that name.
    """
    if text not in tuple(Paper):
        raise UsageProblem(Message("paper is one of {papers}, not {text!r}", papers=", ".join(Paper), text=text))
    return Paper(str(text))


def on_paper(cels: Cels, paper: Paper) -> Cels:
    """Return cels whose drawings are on a paper."""
    return replace(cels, drawings=tuple(replace(drawing, paper=paper) for drawing in cels.drawings))


def set_paper(document: Document, layer_id: str, paper: Paper) -> Document:
    """Put all drawings of a layer on a paper."""
    layer = document.layer(layer_id)
    cels = on_paper(layer.cels, paper)
    if cels == layer.cels:
        return document
    changed = replace(layer, cels=cels)
    return replace(document, layers=tuple(changed if each is layer else each for each in document.layers))
