"""Views of the buffers of glTF files, packed by meshoptimizer or as they are."""

from kagezou.io.sets.gltf import Gltf
from kagezou.io.sets.gltf_tree import entry_of, whole


def view_of(file: Gltf, index: object) -> tuple[memoryview, int]:
    """Return the bytes of a view, and how far its rows lie apart, 0 for one behind the other.

    Raises
    ------
    InputProblem
        It is not there or reaches beyond its buffer.
    """
    view = entry_of(file.path, file.tree, "bufferViews", index)
    return file.buffers.view(view), whole(view.get("byteStride", 0))
