"""The one door to psd-tools: a PSD file is opened once for all its layers.

psd-tools replaces damaged channels by black and says so by a warning; here that is an error. It is imported with the
first file, because it takes a while.
"""

import functools
import logging
import threading
import warnings
from collections import OrderedDict
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

from kagezou.errors import InputProblem
from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.io.psd.comparing import follow_clipped_groups
from kagezou.io.psd.notes import notes_on
from kagezou.io.psd.pixels import PsdPixels, merged_pixels, part_pixels
from kagezou.io.psd.tree import DEEPEST, PsdNode, PsdTree, addressed, psd_header, with_clipped
from kagezou.io.psd.undrawn import undrawn_in
from kagezou.message import Message
from kagezou.picture_source import PicturePart, PictureSource, file_of

_KEPT_BYTES: Final = 256 << 20
"""So large may the files be together that are held open; the last one is always."""

_LARGEST_ARRAY_BYTES: Final = 3 << 29
_MOST_NODES: Final = 20000
_LONGEST_ADDRESS: Final = 4096
"""Longer ones could not be kept in a project."""

_State = tuple[Path, *FileStamp]


class _Opened:
    """A PSD file in memory; used by one thread at a time."""

    def __init__(self, path: Path, size: int) -> None:
        self._path = path
        self.size = size
        self._layers: dict[str, Any] = {}
        self._lock = threading.Lock()
        header = psd_header(path)
        self._image = _parsed(path, size)
        self._notes: tuple[Message, ...] | None = None
        try:
            _check_depth(path, self._image)
            follow_clipped_groups(self._image)
            nodes = self._nodes(self._image, None)
        except InputProblem:
            raise
        except Exception as error:  # a stranger's file may trip psd-tools in any way
            raise _damaged(path, error) from error
        self.tree = PsdTree(header.width_px, header.height_px, nodes)

    def has(self, address: str) -> bool:
        """Return whether there is a layer or a group of this address."""
        return address in self._layers

    def pixels(self, address: str | None) -> PsdPixels:
        """Return a layer or a group, or what the whole file shows."""
        if address is not None and address not in self._layers:
            raise input_problem(self._path, Message("there is no layer {address!r} in it", address=address))
        try:
            with self._lock:
                return merged_pixels(self._image) if address is None else part_pixels(self._layers[address])
        except ImportError as error:
            raise input_problem(
                self._path,
                Message("{layer} has vector shapes that cannot be drawn", layer=address)
                if address
                else Message("it has vector shapes that cannot be drawn"),
            ) from error
        except Exception as error:  # as above
            raise _damaged(self._path, error, address) from error

    def notes(self) -> tuple[Message, ...]:
        """Return what is to be said about the file; the first time it is put together as a whole."""
        try:
            with self._lock:
                if self._notes is None:
                    self._notes = notes_on(self._image)
                return self._notes
        except Exception as error:  # as above
            raise _damaged(self._path, error) from error

    def _nodes(self, group: Iterable[Any], parent: str | None) -> tuple[PsdNode, ...]:
        layers = list(group)
        names = [_name_of(layer) for layer in layers]
        nodes = []
        for layer, name, address in zip(layers, names, addressed(names, parent), strict=True):
            self._layers[address] = layer
            if len(self._layers) > _MOST_NODES:
                raise input_problem(
                    self._path, Message("more than {most_nodes} layers are in it", most_nodes=_MOST_NODES)
                )
            if len(address) > _LONGEST_ADDRESS:
                raise input_problem(
                    self._path, Message("the names of the groups around {name!r} are too long", name=name[:20])
                )
            children = self._nodes(layer, address) if layer.is_group() else None
            nodes.append(
                PsdNode(
                    name=name,
                    address=address,
                    is_visible=layer.visible,
                    children=children,
                    is_clipped=layer.clipping,
                    is_empty=_is_empty(layer) if children is None else all(child.is_empty for child in children),
                    undrawn=undrawn_in(layer),
                    blend=_blend_of(layer),
                    is_adjustment=_is_adjustment(layer),
                )
            )
        return with_clipped(nodes)


class _OpenFiles:
    """Opened files, the least lately used going first; any thread may ask."""

    def __init__(self) -> None:
        self._kept: OrderedDict[_State, _Opened] = OrderedDict()
        self._lock = threading.Lock()

    def opened(self, path: Path) -> _Opened:
        """Return the file at ``path`` as it is on disk now."""
        try:
            status = path.stat()
        except OSError as error:
            raise input_problem(path, error) from error
        except ValueError as error:  # a NUL in the name
            raise input_problem(path, Message("it cannot be a file name")) from error
        state = (path, *stamp_of(status))
        with self._lock:
            for other in [known for known in self._kept if known[0] == path and known != state]:
                del self._kept[other]
            if state not in self._kept:
                self._kept[state] = _Opened(path, status.st_size)
            self._kept.move_to_end(state)
            while len(self._kept) > 1 and sum(each.size for each in self._kept.values()) > _KEPT_BYTES:
                self._kept.popitem(last=False)
            return self._kept[state]


_SHELF: Final = _OpenFiles()


def psd_tree(path: Path) -> PsdTree:
    """Return the groups and layers of the PSD file at ``path``.

    Raises
    ------
    InputProblem
        It cannot be read; one sentence with name and cause.
    """
    return _SHELF.opened(path).tree


def psd_notes(path: Path) -> tuple[Message, ...]:
    """Return what of a PSD file is not used and what had to be assumed, without its name.

    Its layers are put together once and held against the picture that was saved with them.

    Raises
    ------
    InputProblem
        As for `psd_tree`.
    """
    return _SHELF.opened(path).notes()


def has_part(part: PicturePart) -> bool:
    """Return whether a layer is in its file.

    Raises
    ------
    InputProblem
        As for `psd_tree`.
    """
    return _SHELF.opened(part.path).has(part.address)


def psd_pixels(source: PictureSource) -> PsdPixels:
    """Return the pixels of a PSD file, or of the part of it that ``source`` names.

    Raises
    ------
    InputProblem
        As for `psd_tree`, or there is no such part.
    """
    address = source.address if isinstance(source, PicturePart) else None
    return _SHELF.opened(file_of(source)).pixels(address)


@functools.cache
def _configure() -> None:
    from psd_tools.api.utils import PSDLargeImageWarning
    from psd_tools.compression import PSDDecompressionWarning

    warnings.filterwarnings("ignore", module="psd_tools")
    warnings.filterwarnings("error", category=PSDDecompressionWarning)
    warnings.filterwarnings("ignore", category=PSDLargeImageWarning)
    logger = logging.getLogger("psd_tools")
    logger.addHandler(logging.NullHandler())
    logger.propagate = False


def _parsed(path: Path, size: int) -> Any:
    _configure()
    from psd_tools import PSDImage
    from psd_tools.psd.parse_limits import ParseLimits

    # No block can be longer than the file; blocks lie within each other, so their sum may be.
    limits = ParseLimits(max_read_bytes=size + 1, max_total_bytes=16 * size + (1 << 20))
    try:
        return PSDImage.open(path, max_alloc_bytes=_LARGEST_ARRAY_BYTES, parse_limits=limits)
    except OSError as error:
        if error.errno is None:  # psd-tools' own, for a file that ends early
            raise _damaged(path, error) from error
        raise input_problem(path, error) from error
    except Exception as error:  # a stranger's file may trip psd-tools in any way
        raise _damaged(path, error) from error


def _check_depth(path: Path, image: Any) -> None:
    """See that groups are not nested deeper than functions can call themselves, psd-tools' own among them."""
    waiting = [(image, 0)]
    while waiting:
        group, depth = waiting.pop()
        if depth > DEEPEST:
            raise input_problem(path, Message("its groups are nested too deep"))
        waiting += [(each, depth + 1) for each in group if each.is_group()]


def _damaged(path: Path, error: Exception, address: str | None = None) -> InputProblem:
    cause = str(error).strip().partition("\n")[0][:120] or type(error).__name__
    if "over the configured budget" in str(error) or isinstance(error, MemoryError):
        if address:
            return input_problem(path, Message("it is larger than can be read at the layer {layer!r}", layer=address))
        return input_problem(path, Message("it is larger than can be read"))
    if address:
        return input_problem(
            path,
            Message(
                "the file is damaged at the layer {layer!r} or of an unknown kind ({cause})", layer=address, cause=cause
            ),
        )
    return input_problem(path, Message("the file is damaged or of an unknown kind ({cause})", cause=cause))


def _name_of(layer: Any) -> str:
    """Return a layer's name; an old one without Unicode is taken as Japanese where it can be that."""
    from psd_tools.constants import Tag

    name = str(layer.name)
    if Tag.UNICODE_LAYER_NAME not in layer.tagged_blocks and not name.isascii():
        try:
            return name.encode("mac_roman").decode("cp932")
        except UnicodeError:
            return name
    return name.rstrip("\0")


def _is_empty(layer: Any) -> bool:
    if layer.kind in {"pixel", "type", "smartobject"}:
        return layer.width < 1 or layer.height < 1 or not layer.has_pixels()
    return _is_adjustment(layer)


def _is_adjustment(layer: Any) -> bool:
    from psd_tools.api.layers import AdjustmentLayer

    return isinstance(layer, AdjustmentLayer)


def _blend_of(layer: Any) -> str:
    """Return the name of how a layer is laid on those below it, in small letters; empty for simply over them."""
    name = str(layer.blend_mode.name).lower().replace("_", " ")
    return "" if name in {"normal", "pass through"} else name
