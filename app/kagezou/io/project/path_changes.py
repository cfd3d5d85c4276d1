"""The files of a document elsewhere, or as they are spelled on the disk."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from kagezou.document.model import Cels, Document
from kagezou.io.files.spellings import Listings, has_spellings, on_disk


def with_paths(document: Document, changed: Callable[[Path], Path]) -> Document:
    """Return the document with another path for each of its pictures and sets; itself where none changes."""
    paths = {drawing.path for cels in _cels_of(document) for drawing in cels.drawings}
    paths |= {piece.source for piece in document.pieces if piece.source is not None}
    moved = {path: new for path in paths if (new := changed(path)) != path}
    if not moved:
        return document

    def moved_cels(cels: Cels) -> Cels:
        return replace(
            cels, drawings=tuple(replace(each, path=moved.get(each.path, each.path)) for each in cels.drawings)
        )

    layers = tuple(replace(layer, cels=moved_cels(layer.cels)) for layer in document.layers)
    pieces = tuple(
        piece if piece.source is None else replace(piece, source=moved.get(piece.source, piece.source))
        for piece in document.pieces
    )
    return replace(document, layers=layers, behind=moved_cels(document.behind), pieces=pieces)


def as_on_disk(document: Document) -> Document:
    """Return the document with its files as they are spelled on the disk.

    Only names that Unicode can write in two ways are looked for; nothing is opened.
    """
    listings: Listings = {}
    return with_paths(document, lambda path: on_disk(path, listings) if has_spellings(str(path)) else path)


def _cels_of(document: Document) -> list[Cels]:
    return [document.behind, *(layer.cels for layer in document.layers)]
