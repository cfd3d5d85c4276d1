"""What of the files of a document is not there."""

from collections.abc import Iterator
from contextlib import suppress

from kagezou.document.model import Document
from kagezou.errors import InputProblem
from kagezou.io.files.faults import shown
from kagezou.io.images.parts import has_part
from kagezou.picture_source import PicturePart, file_of


def missing_names(document: Document) -> Iterator[str]:
    """Yield the files that are not there, and the layers that are not in their files, each once."""
    every = (*(layer.cels for layer in document.layers), document.behind)
    sources = [drawing.source for cels in every for drawing in cels.drawings]
    files = [*map(file_of, sources), *(piece.source for piece in document.pieces if piece.source is not None)]
    yield from (shown(path) for path in dict.fromkeys(files) if not path.is_file())
    for part in dict.fromkeys(each for each in sources if isinstance(each, PicturePart) and each.path.is_file()):
        with suppress(InputProblem):  # a broken file is not missing
            if not has_part(part):
                yield f"{shown(part.path)} ({part.address})"
