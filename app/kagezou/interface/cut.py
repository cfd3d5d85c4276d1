"""A cut as a value: what changes it returns another one, and nothing else changes."""

from collections.abc import Generator, Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal, TypeAlias

from kagezou.animation.track import Value
from kagezou.document.address import resolve
from kagezou.document.edits import remove_key
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.interface import changes
from kagezou.interface.exporting import AfterExport, Exported, ExportJob, exported
from kagezou.interface.keeping import held, kept
from kagezou.interface.pictures import PictureWish, PixelType, RenderedFrame, rendered, sequence_names
from kagezou.interface.values import (
    AnyPath,
    FrameChoice,
    ProgressCallback,
    PropertyKey,
    StopCallback,
    frames_of,
    never,
    no_progress,
    path_of,
)
from kagezou.interface.wishes import ExportWish
from kagezou.io.project.file_state import FileState
from kagezou.message import Message
from kagezou.render.gpu.context import OpenContext
from kagezou.scene.spoken_values import spoken_value

PartName: TypeAlias = Literal["light", "look", "ground", "set"]
"""What one cut can take of another."""


@dataclass(frozen=True, slots=True, repr=False)
class Cut:
    """A cut; `kagezou.open` and `kagezou.new` make it.

    It is a value: methods that begin with ``with`` return another cut. It may be kept, compared and handed to any
    thread. Paths of properties are those of ``kagezou set``, as ``kagezou info PROJECT.kage --properties`` lists them.
    A path, a name, a frame or a value that cannot be is a `UsageProblem`.

    Parameters
    ----------
    path
        The project file; None while it was never saved.
    notes
        What was said of it since it was opened, one sentence each: what was assumed, not used or limited.
    """

    path: Path | None
    notes: tuple[str, ...] = field(compare=False)
    _document: Document
    _open_context: OpenContext = field(compare=False)
    _seen: FileState | None = field(default=None, compare=False)

    def __repr__(self) -> str:
        canvas = self._document.canvas
        where = "unsaved" if self.path is None else str(self.path)
        return f"<Cut {where}: {canvas.width_px} x {canvas.height_px} px, {canvas.length_frames} frames>"

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of the canvas, px."""
        return self._document.canvas.width_px, self._document.canvas.height_px

    @property
    def length(self) -> int:
        """How many frames it has; they count from 1."""
        return self._document.canvas.length_frames

    @property
    def characters(self) -> tuple[str, ...]:
        """The names of its layers from bottom to top, parts of figures as well."""
        return tuple(layer.name for layer in self._document.layers)

    @property
    def paths(self) -> tuple[str, ...]:
        """The paths of everything that can be set."""
        return tuple(changes.paths(self._document))

    def check(self) -> tuple[str, ...]:
        """Return what is missing of its files and what of the others is not used; each file's header is read."""
        return tuple(changes.file_notes(self._document))

    def value(self, path: str, frame: int | None = None) -> Value:
        """Return the value at a path; of a property that has keys on a frame, which is needed then."""
        found = spoken_value(self._document, path, frame)
        if found.value is None:
            raise UsageProblem(Message("{path} has keys: its value is that of a frame, which is needed", path=path))
        return found.value

    def keys(self, path: str) -> tuple[PropertyKey, ...]:
        """Return the keys at a path in the order of their frames; nothing where one value holds for the whole cut."""
        found = spoken_value(self._document, path)
        return tuple(PropertyKey(key.frame, key.value, key.interpolation.value) for key in found.keys)

    def with_value(
        self,
        path: str,
        value: object,
        frame: int | None = None,
        *,
        interpolation: str | None = None,
        ease: bool = False,
    ) -> "Cut":
        """Return the cut with a value: for the whole cut, so that keys go, or as a key on a frame.

        Parameters
        ----------
        path
            Such as ``"light.position"`` or ``"layers.Hero.shadow.opacity"``.
        value
            A number, a truth, a tuple, or words as ``kagezou set`` takes them.
        frame
            From 1; None for the whole cut.
        interpolation
            ``"hold"``, ``"linear"`` or ``"bezier"``; None for as the neighbours go on.
        ease
            Whether the way to the key is eased at both of its ends.
        """
        key = changes.key_of(frame, interpolation, ease=ease)
        return self._changed(*changes.with_values(self._document, {path: value}, key))

    def with_values(self, values: Mapping[str, object], frame: int | None = None) -> "Cut":
        """Return the cut with several values, all of them or none; otherwise as `with_value`."""
        return self._changed(*changes.with_values(self._document, values, changes.key_of(frame)))

    def without_key(self, path: str, frame: int) -> "Cut":
        """Return the cut without the key on a frame; the last one leaves its value for the whole cut."""
        return self._changed(remove_key(self._document, resolve(self._document, path), frame), ())

    def with_feet(
        self, *characters: str, progress: ProgressCallback = no_progress, stop: StopCallback = never
    ) -> "Cut":
        """Return the cut with the feet of characters found in their drawings, of all without names.

        What a person said of feet stays. Drawings are decoded on two threads, from which ``progress`` and ``stop`` are
        called, one at a time; where ``stop`` says so, `Stopped` is raised.
        """
        return self._changed(*changes.with_feet(self._document, characters, progress, stop))

    def with_style(self, name: str, *characters: str, frame: int = 1, with_light: bool = False) -> "Cut":
        """Return the cut in a style, on characters by their names or on all.

        Parameters
        ----------
        name
            One of `kagezou.styles`, in English or Japanese.
        frame
            Where properties that have keys get one.
        with_light
            Whether the style's own light comes as well, with ground and set-up where it has them.
        """
        return self._changed(*changes.with_style(self._document, (name, *characters), frame, with_light=with_light))

    def with_parts_of(self, other: "Cut", *parts: PartName, frame: int = 1) -> "Cut":
        """Return the cut with parts of another one, as ``kagezou apply`` takes them; all of them without names."""
        return self._changed(*changes.with_parts(self._document, document_of(other), parts, frame))

    def save(self, path: AnyPath | None = None, *, force: bool = False) -> "Cut":
        """Write the project, as a whole or not at all, and return the cut as it lies there.

        Parameters
        ----------
        path
            Where to; None for where it was opened.
        force
            Whether another file that lies there, or what somebody else has written since it was opened, is replaced.

        Raises
        ------
        UsageProblem
            It was never saved, and no path is given.
        OutputProblem, DiskFullProblem, ProjectProblem
            There is something else by now, or it cannot be written; what is there stays.
        """
        where = self.path if path is None else path_of(path)
        if where is None:
            raise UsageProblem(Message("this cut was never saved: save it with a path"))
        seen = self._seen if where == self.path else None
        with held(where) as said:
            return kept_cut(self, where, seen, said, force=force)

    @property
    def sequences(self) -> tuple[str, ...]:
        """What can be drawn, as ``kagezou render`` names folders: ``"Hero_shadow"``, ``"composite"`` and others."""
        return sequence_names(self._document)

    def pictures(
        self,
        name: str,
        frames: FrameChoice = None,
        *,
        numbers: PixelType = "uint8",
        progress: ProgressCallback = no_progress,
        stop: StopCallback = never,
    ) -> Generator[RenderedFrame, None, None]:
        """Draw pictures of one of `sequences`, one after the other as they are taken, and yield each with its frame.

        An OpenGL context lives from the first picture to the last, or until the iterator is closed, on the thread that
        calls this; take all pictures there. Other threads read drawings ahead.

        Raises
        ------
        UsageProblem, InputProblem, GraphicsProblem
            There is no such sequence or frame, a drawing cannot be read, or there is no OpenGL.
        """
        wish = PictureWish(name, frames_of(frames), numbers)
        return rendered(self._document, wish, self._open_context, progress, stop)

    def export(
        self,
        wish: ExportWish,
        *,
        progress: ProgressCallback = no_progress,
        stop: StopCallback = never,
        after: AfterExport = None,
    ) -> Exported:
        """Write files: a `Frames`, `Video`, `AfterEffects` or `SceneFor`; and do what comes after it.

        Raises
        ------
        UsageProblem, InputProblem, OutputProblem, DiskFullProblem, GraphicsProblem
            As for the command line; every file that is there is whole.
        HandingOnFailed
            The export is whole, and is its ``exported``, but what comes after it failed.
        """
        return exported(ExportJob(self._document, self.path, self._open_context, progress, stop), wish, after)

    def _changed(self, document: Document, notes: Iterable[Message]) -> "Cut":
        return replace(self, _document=document, notes=_once(self.notes, notes))


def document_of(cut: Cut) -> Document:
    """Return what a cut holds, for the rooms below."""
    return cut._document  # noqa: SLF001 - of this module


def kept_cut(cut: Cut, path: Path, seen: FileState | None, said: Iterable[Message], *, force: bool) -> Cut:
    """Write the project of a cut that is held, as `kept` does, and return the cut as it lies there."""
    state = kept(document_of(cut), path, seen, force=force)
    return replace(cut, path=path, _seen=state, notes=_once(cut.notes, said))


def _once(before: tuple[str, ...], notes: Iterable[Message]) -> tuple[str, ...]:
    """Return what was said before and what is new of it."""
    return tuple(dict.fromkeys((*before, *(str(each) for each in notes))))
