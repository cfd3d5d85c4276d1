"""What a hand-off renders: versions of the document, each as sequences in a folder of its own."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Final

from kagezou.document.model import Document
from kagezou.export import request
from kagezou.export.after_effects.mattes import at_full_opacity, matte_document
from kagezou.export.selection import ever_clay, ever_has_contact, ever_is_mirrored, ever_receives
from kagezou.export.sequences import OutputSequence
from kagezou.export.subjects import SetShadowSubject
from kagezou.export.uniting import cut_groups


@dataclass(frozen=True, slots=True)
class Rendering:
    """One version of the document, and what becomes of its pictures.

    Parameters
    ----------
    tag
        What the tags of its footage begin with; a second run of the script knows footage by them.
    folder
        The name of its folder.
    footage_name
        What its footage is called, with ``{}`` for whose it is.
    only
        Which sequences it has, as of `ExportRequest`.
    version
        Makes the document that is rendered.
    is_matte
        Whether it is a matte, which is laid into no composition of the characters.
    takes_set
        Whether the shadow of the set itself becomes footage too.
    """

    tag: str
    folder: str
    footage_name: str
    only: str
    version: Callable[[Document], Document]
    is_matte: bool = False
    takes_set: bool = False

    def takes(self, sequence: OutputSequence) -> bool:
        """Return whether a sequence that was rendered becomes footage."""
        return self.takes_set or sequence.subject != SetShadowSubject()


def _as_it_is(document: Document) -> Document:
    """Return the document: at the opacity of those who cast, which one property there could not tell."""
    return document


def _matte(matte: str, *, takes_set: bool = False) -> Rendering:
    """Return the rendering of shadows as a matte: "shadow", "core" or "distance"."""
    version = partial(matte_document, matte=matte)
    name = f"{{}} {matte} matte"
    return Rendering(
        f"matte:{matte}", f"matte_{matte}", name, request.SHADOWS, version, is_matte=True, takes_set=takes_set
    )


SHADOWS: Final = Rendering("shadow", "shadows", "{} shadow", request.SHADOWS, at_full_opacity, takes_set=True)
RECEIVED: Final = Rendering("received", "shadows", "{} received", request.RECEIVED, _as_it_is)
CONTACTS: Final = Rendering("contact", "shadows", "{} contact", request.CONTACTS, at_full_opacity)
REFLECTIONS: Final = Rendering("reflection", "shadows", "{} reflection", request.REFLECTIONS, at_full_opacity)
TOGETHER: Final = Rendering("shadow", "shadows", "{} shadows", request.TOGETHER, _as_it_is)
CLAY: Final = Rendering("background", "set", "{}", request.CLAY, _as_it_is)
"""Of the kind of the background, which it lies beside."""
SHADOW_MATTES: Final = _matte("shadow", takes_set=True)
RECEIVER_MATTES: Final = Rendering(
    "matte:receivers", "matte_receivers", "{} matte", request.RECEIVERS, _as_it_is, is_matte=True
)
_BY_MATTE: Final = {
    "shadow": SHADOW_MATTES,
    "core": _matte("core"),
    "distance": _matte("distance"),
    # A composition of the shadows alone.
    "lit": SHADOW_MATTES,
    "receivers": RECEIVER_MATTES,
}
"""By the keys of `MATTES`."""


def matte_renderings(mattes: tuple[str, ...]) -> tuple[Rendering, ...]:
    """Return what keys of `MATTES` ask for, each once."""
    return tuple(dict.fromkeys(_BY_MATTE[matte] for matte in mattes))


def renderings_of(document: Document, mattes: tuple[str, ...]) -> tuple[Rendering, ...]:
    """Return what is to be rendered of a document with some mattes, those of receivers last."""
    asked = sorted(matte_renderings(mattes), key=lambda each: each == RECEIVER_MATTES)
    received = (RECEIVED,) if any(map(ever_receives, document.layers)) else ()
    contacts = (CONTACTS,) if any(map(ever_has_contact, document.layers)) else ()
    reflections = (REFLECTIONS,) if any(map(ever_is_mirrored, document.layers)) else ()
    clay = (CLAY,) if ever_clay(document) else ()
    together = (TOGETHER,) if cut_groups(document, of_one_color=True).together() else ()
    return (SHADOWS, *together, *received, *contacts, *reflections, *clay, *asked)
