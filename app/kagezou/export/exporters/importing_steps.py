"""How pictures of an export are brought into a compositing program, in words."""

from typing import Final

from kagezou.document import properties
from kagezou.document.model import Document
from kagezou.document.values import value_at
from kagezou.message import Message

_SEQUENCE_NAMES: Final = {"png": "PNG", "tga": "Targa", "tiff": "TIFF", "exr": "OpenEXR", "psd": "Photoshop"}
"""What After Effects calls a sequence of a format."""


def rate_words(document: Document) -> str:
    """Return the frame rate as it is typed: 24, 23.976."""
    return f"{float(document.canvas.frame_rate):.6g}"


def sequence_step(document: Document, form: str) -> Message:
    """Return how numbered frames of a format are imported, and what their alpha is."""
    rate = rate_words(document)
    if form == "exr":
        return Message(
            "Import each folder as one sequence of {rate} frames a second; EXR is linear, its alpha premultiplied.",
            rate=rate,
        )
    return Message(
        "Import each folder as one sequence of {rate} frames a second, with straight (unmatted) alpha.", rate=rate
    )


def after_effects_step(form: str) -> Message:
    """Return where After Effects imports a sequence of a format."""
    return Message(
        "In After Effects: File > Import > File…, choose the first picture of a folder and tick “{format} Sequence”.",
        format=_SEQUENCE_NAMES[form],
    )


def laying_step(document: Document) -> Message:
    """Return where shadows are laid, and how."""
    if all(value_at(layer.tracks, properties.BLEND, 1) == "multiply" for layer in document.layers):
        return Message("Lay each shadow under its character and set it to Multiply.")
    return Message("Lay each shadow under its character, in the blend mode that it has here.")
