"""The buffers of glTF files: beside them, inside them or in the tree itself, read when they are first needed."""

import base64
import binascii
from pathlib import Path
from typing import Final
from urllib.parse import unquote, unquote_to_bytes

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.bounded_bytes import MAX_BYTES, bytes_of, check_inside
from kagezou.io.sets.gltf_tree import Tree, entry_of, whole
from kagezou.message import Message

_MAX_BUFFERS: Final = 1000


class Buffers:
    """The buffers of a file, each read once; one that nobody needs may be missing.

    Parameters
    ----------
    path, tree
        The file.
    binary
        The numbers within a GLB.
    """

    def __init__(self, path: Path, tree: Tree, binary: bytes) -> None:
        self._path, self._tree, self._binary = path, tree, binary
        self._read: dict[int, bytes] = {}

    def data(self, index: object) -> bytes:
        """Return what is in a buffer.

        Raises
        ------
        InputProblem
            It is missing, shorter than the file says, or lies outside the file's folder.
        """
        buffer = entry_of(self._path, self._tree, "buffers", index)
        number = whole(index)
        if number not in self._read:
            self._read[number] = self._data(buffer)
            # One file may be named many times.
            if sum(map(len, self._read.values())) > MAX_BYTES or len(self._read) > _MAX_BUFFERS:
                raise input_problem(
                    self._path,
                    Message("its buffers are larger than {megabytes} MB or too many", megabytes=MAX_BYTES >> 20),
                )
        return self._read[number]

    def view(self, view: Tree) -> memoryview:
        """Return the bytes of a part of a buffer, told by ``buffer``, ``byteOffset`` and ``byteLength``.

        Raises
        ------
        InputProblem
            It reaches beyond the buffer, or see `data`.
        """
        data = self.data(view["buffer"])
        start, length = whole(view.get("byteOffset", 0)), whole(view["byteLength"])
        if start + length > len(data):
            raise input_problem(self._path, Message("it is damaged: it refers to more numbers than it holds"))
        return memoryview(data)[start : start + length]

    def _data(self, buffer: Tree) -> bytes:
        length, uri = whole(buffer["byteLength"]), buffer.get("uri")
        if uri is None:
            data = self._binary
        elif uri[:5].lower() == "data:":
            data = self._inside(uri)
        else:
            name = unquote(uri)
            check_inside(self._path, name)
            data = bytes_of(self._path.parent / name)
        if len(data) < length:
            raise input_problem(self._path, Message("it is damaged: a buffer is shorter than it should be"))
        return data

    def _inside(self, uri: str) -> bytes:
        """Return the bytes that a ``data:`` address is made of, as base64 text or else with escaped bytes."""
        head, _, text = uri.partition(",")
        if not head.lower().endswith(";base64"):
            return unquote_to_bytes(text)
        bare = "".join(unquote(text).split()).rstrip("=")
        try:
            return base64.b64decode(bare + "=" * (-len(bare) % 4), validate=True)
        except (binascii.Error, ValueError) as error:
            raise input_problem(self._path, Message("it is damaged: a buffer in it is not base64 text")) from error
