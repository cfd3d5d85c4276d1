"""Parts of picture files: layers of PSD and OpenEXR files, pages and films of others."""

from pathlib import Path

from kagezou.io.images.opening import opened
from kagezou.io.pixels.signatures import FORMATS, is_psd
from kagezou.picture_source import PicturePart


def has_part(part: PicturePart) -> bool:
    """Return whether a layer or a page is in its file.

    Raises
    ------
    InputProblem
        The file cannot be read.
    """
    if is_psd(part.path):
        from kagezou.io.psd.file import has_part as has_psd_part

        return has_psd_part(part)
    if is_exr(part.path):
        return part.address in exr_layer_names(part.path)
    with opened(part.path, whole=False) as picture:
        count = picture.pictures()
    return part.address in {str(number) for number in range(1, count + 1)}


def exr_layer_names(path: Path) -> tuple[str, ...]:
    """Return the names of the layers of an OpenEXR file that can be a picture, the one that is used by itself first.

    A layer without a name has an empty one.

    Raises
    ------
    InputProblem
        It cannot be read.
    """
    from kagezou.io.images.oiio_guard import DecodedPicture

    with DecodedPicture(path, whole=False) as picture:
        return picture.layer_names()


def is_exr(path: Path) -> bool:
    """Return whether the suffix of ``path``, in any case, is that of an OpenEXR file."""
    return FORMATS.get(path.suffix.lower()) == "openexr"
