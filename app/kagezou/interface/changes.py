"""What scripts change of a document, each with what is to be said of it."""

from collections.abc import Iterator, Mapping, Sequence
from threading import Lock
from typing import TypeAlias

from kagezou.animation.track import Interpolation
from kagezou.document.address import addresses, path_of
from kagezou.document.cut_words import CUT_WORDS, CutWord, cut_word_at
from kagezou.document.layer_named import layer_named
from kagezou.document.model import Document
from kagezou.document.refitting import Refit
from kagezou.document.spoken import AsKey, put, with_cut_words
from kagezou.document.styling import LeftOut, notes_on, put_style
from kagezou.document.taking import Part, taken
from kagezou.document.whole_cut import sayings
from kagezou.errors import Stopped, UsageProblem
from kagezou.importing.consequences import settled
from kagezou.importing.feet import document_with_feet
from kagezou.importing.file_notes import notes_on_files
from kagezou.importing.missing_files import missing_names
from kagezou.importing.progress import LoadPhase
from kagezou.interface.values import ProgressCallback, StopCallback, raw_of, whole
from kagezou.io.clips.style_files import named_style, styles_there
from kagezou.io.sets.mesh_cache import MeshCache
from kagezou.locations import own_style_folder
from kagezou.message import Message
from kagezou.scene.misfits import misfits_of, new_misfits

Changed: TypeAlias = tuple[Document, tuple[Message, ...]]
"""A document, and what is to be said of how it came about."""


def paths(document: Document) -> Iterator[str]:
    """Yield the paths of everything that can be set."""
    yield from (word.path for word in CUT_WORDS)
    yield from (path_of(document, address) for address in addresses(document))
    yield from (said.path for said in sayings(document))


def file_notes(document: Document) -> Iterator[str]:
    """Yield which files are missing, and what the readers of the others say."""
    yield from (f"missing: {name}" for name in missing_names(document))
    yield from map(str, notes_on_files(document, MeshCache()))


def key_of(frame: int | None, interpolation: str | None = None, *, ease: bool = False) -> AsKey | None:
    """Return the key that a value becomes; None without a frame.

    Raises
    ------
    UsageProblem
        There is no such interpolation, or there can be none without a frame.
    """
    if frame is None:
        if interpolation is not None or ease:
            raise UsageProblem(Message("interpolation and ease are of a key, which needs a frame"))
        return None
    frame = whole(frame)
    if interpolation is None:
        return AsKey(frame, None, ease)
    known = [each.value for each in Interpolation]
    if interpolation not in known:
        words = ", ".join(known)
        raise UsageProblem(Message("{name!r} is no interpolation, only {known}", name=interpolation, known=words))
    return AsKey(frame, Interpolation(interpolation), ease)


def with_values(document: Document, values: Mapping[str, object], key: AsKey | None) -> Changed:
    """Return the document with values at paths; those of the canvas come first, and the others are meant on it.

    Raises
    ------
    UsageProblem
        There is no such path, or a value cannot be its.
    """
    words: list[tuple[CutWord, object]] = []
    others: dict[str, object] = {}
    for path, value in values.items():
        word = cut_word_at(path)
        if word is None:
            others[path] = raw_of(path, value)
        else:
            words.append((word, value if isinstance(value, str) else _plain(value)))
    if words and key is not None:
        raise UsageProblem(Message("{path} is the same on every frame and has no keys", path=words[0][0].path))
    placed = with_cut_words(document, words, Refit.CENTRE)
    after = placed.document
    for path, raw in others.items():
        after = put(after, path, raw, key)
    if after is document:
        return document, placed.notes
    after, said = settled(document, placed.document, after)
    return after, (*placed.notes, *said)


def _plain(value: object) -> object:
    """Return a setting of the canvas as it is read: a size may be a tuple, a rate a fraction."""
    return list(value) if isinstance(value, tuple) else value if isinstance(value, int | float | list) else str(value)


def with_feet(document: Document, names: Sequence[str], progress: ProgressCallback, stop: StopCallback) -> Changed:
    """Return the document with the feet of layers, of all without names.

    Raises
    ------
    UsageProblem
        There is no such layer.
    Stopped
        That was asked for.
    """
    ids = [layer_named(document, name).id for name in names] or [layer.id for layer in document.layers]
    lock = Lock()

    def tell(_part: LoadPhase, done: int, whole: int) -> None:
        with lock:
            if stop():
                raise Stopped
            progress(done, whole)

    found = document_with_feet(document, ids, tell)
    return found.document, found.notes


def with_style(document: Document, words: Sequence[str], frame: int, *, with_light: bool) -> Changed:
    """Return the document in the style of the first word, on the characters of the others, on all without them.

    Raises
    ------
    UsageProblem
        There is no such style or character, or the light of all would change for some.
    """
    there, problems = styles_there(own_style_folder())
    style = named_style(words[0], there)
    ids = [layer_named(document, name).id for name in words[1:]]
    figures = [layer.id for layer in document.layers if layer.joins is None]
    if not figures:
        raise UsageProblem(Message("there is no character in this cut"))
    styled = put_style(document, ids or figures, style, frame, with_light=with_light)
    if styled.left_out is LeftOut.NOT_EVERYBODY:
        raise UsageProblem(
            Message("{style} would change the light of all characters, and only some are meant", style=style.name.en)
        )
    said = notes_on(styled, style.name.en, "with_light=True", lambda address: path_of(document, address))
    misfits = new_misfits(misfits_of(document), misfits_of(styled.document))
    lightless = (Message("{style} has no light of its own", style=style.name.en),) if with_light else ()
    return styled.document, (
        *(problem.message for problem in problems),
        *said,
        *(lightless if not style.scene else ()),
        *(misfit.message for misfit in misfits),
    )


def with_parts(document: Document, source: Document, names: Sequence[str], frame: int) -> Changed:
    """Return the document with parts of another one, with all without names.

    Raises
    ------
    UsageProblem
        There is no such part.
    """
    known = [part.value for part in Part]
    for name in names:
        if name not in known:
            words = ", ".join(known)
            raise UsageProblem(Message("{name!r} is no part of a cut, only {known}", name=name, known=words))
    done = taken(document, source, frozenset(map(Part, names or known)), frame)
    return done.document, done.notes
