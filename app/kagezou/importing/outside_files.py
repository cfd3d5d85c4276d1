"""Files of a project that lie outside its folder: a stranger's project may name any file of this computer."""

from pathlib import Path

from kagezou.document.model import Document
from kagezou.io.files.faults import shown
from kagezou.io.project.paths import absolute
from kagezou.message import Message, first_names


def note_on_outside_files(document: Document, project: Path) -> Message | None:
    """Return what is said of drawings, backgrounds and sets that are not below the project's folder; None without any.

    Only the text of their paths is looked at. They are read where they are needed, and nothing is written there.
    """
    folder = absolute(project).parent
    every = (*(layer.cels for layer in document.layers), document.behind)
    files = [drawing.path for cels in every for drawing in cels.drawings]
    files += [piece.source for piece in document.pieces if piece.source is not None]
    outside = [path for path in dict.fromkeys(files) if not path.is_relative_to(folder)]
    if not outside:
        return None
    if len(outside) == 1:
        return Message(
            "{path}: it lies outside the project's folder and is only read, never written", path=shown(outside[0])
        )
    folders = first_names(shown(each) for each in dict.fromkeys(path.parent for path in outside))
    return Message(
        "{count} files lie outside the project's folder and are only read, never written: {folders}",
        count=len(outside),
        folders=folders,
    )
