"""Opening the picture that a source means, by whichever decoder gives all of it."""

import threading
from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Protocol

from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.files.file_stamp import FileStamp, stamp_of
from kagezou.io.images.header import Header
from kagezou.io.images.plain_png import plain_png
from kagezou.io.pixels.signatures import FORMATS, checked_format
from kagezou.message import Message
from kagezou.picture_source import PicturePart, PictureSource, file_of

if TYPE_CHECKING:  # each decoder is loaded with the first file that needs it
    from kagezou.io.images.oiio_guard import DecodedPicture
    from kagezou.io.images.pillow_guard import PillowFile

Pixels = NDArray[Any]
_KEPT_BYTES: Final = 256 << 20
"""So much may the files and pictures take together that are held in memory; a larger one is not held at all."""

_LARGEST_FILE_BYTES: Final = 512 << 20
_LARGE_TARGA_BYTES: Final = 256 << 20
_FILMS: Final = frozenset({"png", "webp", "gif"})
_State = tuple[Path, *FileStamp]


class OpenPicture(Protocol):
    """A picture whose header has been read."""

    @property
    def header(self) -> Header:
        """What the file says of it."""
        ...

    def used(self) -> Pixels:
        """Return the channels that are used, (H, W, C) in the order of ``header.used``; raises InputProblem."""
        ...

    def alpha(self) -> Pixels:
        """Return the alpha alone, (H, W), where the header has one; raises InputProblem."""
        ...

    def pictures(self) -> int:
        """Return how many pictures the file has."""
        ...


class _InMemory:
    """A picture of a file that Pillow decodes."""

    def __init__(self, header: Header, read: Callable[[], Pixels], pictures: int = 1) -> None:
        self.header = header
        self.used = read
        self._pictures = pictures

    def alpha(self) -> Pixels:
        assert self.header.alpha is not None
        return self.used()[..., self.header.alpha]

    def pictures(self) -> int:
        return self._pictures


class _OpenFiles:
    """Files in memory, the least lately used going first, so that a film is not begun anew for each picture."""

    def __init__(self) -> None:
        self._kept: OrderedDict[_State, PillowFile] = OrderedDict()
        self._lock = threading.Lock()

    def opened(self, path: Path) -> "PillowFile":
        """Return the file at ``path`` as it is on disk now; raises InputProblem."""
        from kagezou.io.images.pillow_guard import PillowFile

        checked_format(path, whole=False)
        try:
            status = path.stat()
            state = (path, *stamp_of(status))
            with self._lock:
                for other in [known for known in self._kept if known[0] == path and known != state]:
                    del self._kept[other]
                if state not in self._kept:
                    if status.st_size > _LARGEST_FILE_BYTES:
                        raise input_problem(
                            path,
                            Message("with {megabytes} MB it is larger than can be read", megabytes=state[1] >> 20),
                        )
                    self._kept[state] = PillowFile(path, path.read_bytes())
                self._kept.move_to_end(state)
                found = self._kept[state]
                while sum(each.nbytes for each in self._kept.values()) > _KEPT_BYTES:
                    self._kept.popitem(last=False)
                return found
        except OSError as error:
            raise input_problem(path, error) from error


_SHELF: Final = _OpenFiles()


@contextmanager
def opened(source: PictureSource, *, whole: bool = True) -> Iterator[OpenPicture]:
    """Open a picture for the time of a ``with``.

    Parameters
    ----------
    source
        A file, which means the first picture or the layer of it that is the picture itself; or a layer or a page of it.
    whole
        Whether its pixels will be wanted, so that its checksums are worth looking at first.

    Raises
    ------
    InputProblem
        Whatever keeps it from being opened, as one sentence.
    """
    path = file_of(source)
    address = source.address if isinstance(source, PicturePart) else None
    form = FORMATS.get(path.suffix.lower())
    if form == "gif" or (form in _FILMS and address is not None):
        yield _of_film(path, address)
        return
    if form == "png":
        checked_format(path, whole=whole)
        if (plain := plain_png(path)) is not None:
            yield plain
            return
    if form == "targa":
        from kagezou.io.images import targa

        checked_format(path, whole=False)
        if targa.is_needed(path):
            picture = targa.TargaPicture(path)
            yield _InMemory(picture.header, picture.read)
            return
    with _decoded(path, address, whole=whole) as decoded:
        header = decoded.header
        is_for_pillow = header.is_for_pillow or _is_large_targa(header)
        if not is_for_pillow:
            yield decoded
    if is_for_pillow:
        other = _of_film(path, address)
        yield _InMemory(header, other.used) if _is_large_targa(header) else other


def _decoded(path: Path, address: str | None, *, whole: bool) -> "DecodedPicture":
    from kagezou.io.images.oiio_guard import DecodedPicture

    return DecodedPicture(path, whole=whole, address=address)


def durations_ms(path: Path) -> tuple[float, ...]:
    """Return how long each picture of a film is seen, 0 where the file does not say; raises InputProblem."""
    return _SHELF.opened(path).durations_ms()


def _is_large_targa(header: Header) -> bool:
    """Return whether a TGA is so large that the memory counts, of which OpenImageIO takes three times the picture's."""
    return header.format == "targa" and header.data[2] * header.data[3] * header.channels > _LARGE_TARGA_BYTES


def _of_film(path: Path, address: str | None) -> OpenPicture:
    from kagezou.io.images.oiio_header import page_index

    film = _SHELF.opened(path)
    index = page_index(path, address)
    film.check(index)
    return _InMemory(film.header, lambda: film.read(index), film.pictures)
