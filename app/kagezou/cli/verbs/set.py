"""``kagezou set``: properties, for the whole cut or by keys; all of them or none."""

from argparse import Namespace
from collections.abc import Iterator
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import holding_project
from kagezou.cli.terminal import note
from kagezou.errors import UsageProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.cut_words import CutWord
    from kagezou.document.model import Document
    from kagezou.document.spoken import AsKey

DESCRIPTION = """\
Set properties. Without --frame a value holds for the whole cut and its keys go; with it, it becomes a key.
What is said of the canvas comes first; properties are then meant on the new one.
Everything is checked before anything is written."""
EXAMPLES = """\
  kagezou set walk.kage light.position=1400,-300,900
  kagezou set walk.kage 'layers.Hero.shadow.color=#1A2340' layers.Hero.shadow.opacity=0.5 light.kind=sun
  kagezou set walk.kage light.azimuth=-40 --frame 1
  kagezou set walk.kage light.azimuth=40 --frame 48 --ease      slowly off and slowly on between the two
  kagezou set water.kage --loop-waves        the last frame leads into the first
  kagezou set walk.kage 'layers.Hero.grounding=[[420,900],[510,900]]'
  kagezou set walk.kage layers.arm.joins=Hero      one more cel of Hero; "" makes it a character of its own
  kagezou set walk.kage layers.Hero.paper=border        drawings without alpha: white inside outlines stays (or white)
  kagezou set walk.kage canvas.size=3840x2160 --drawings scale      or centre (the usual), or stay at the top left
  kagezou set walk.kage canvas.fps=25 canvas.length=48 canvas.first_frame=101 canvas.scene=3 canvas.cut=12
  kagezou info walk.kage --properties        lists every PATH
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to change")
    parser.add_argument(
        "assignments",
        nargs="*",
        default=[],
        metavar="PATH=JSON",
        help="a property and its value as JSON; words such as sun, #20203A and true need no quotes, nor 1400,-300,900",
    )
    parser.add_argument(
        "--loop-waves",
        action="store_true",
        help="set the speeds of all waves to the nearest at which the last frame of the cut leads into the first",
    )
    parser.add_argument(
        "--drawings",
        choices=("stay", "centre", "scale"),
        help="with canvas.size: drawings, light and set stay at the top left, go to the middle (usual) or scale",
    )
    parser.add_argument("--frame", type=whole_number, metavar="N", help="set a key on this frame, counted from 1")
    parser.add_argument(
        "--interp", choices=("hold", "linear", "bezier"), help="how the value goes on from the key (as its neighbours)"
    )
    parser.add_argument(
        "--ease", action="store_true", help="ease the way to the key from the one before it, at both of its ends"
    )


@holding_project
def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Load, change, and write the project if it changed."""
    from kagezou.importing.consequences import settled
    from kagezou.io.project.file import load, save

    _check(options)
    key = _key(options)
    before = load(options.project)
    on_canvas, others = _canvas_first(options.assignments)
    canvas_set = document = _cut_set(before, on_canvas, options)
    for text in others:
        document = _assigned(document, text, key)
    if options.loop_waves:
        document = _looping(document)
    if document is before:
        return 0
    document, said = settled(before, canvas_set, document)
    for sentence in said:
        note(sentence)
    save(document, options.project)
    return 0


def _check(options: Namespace) -> None:
    """Refuse what cannot be meant."""
    if not options.assignments and not options.loop_waves:
        raise UsageProblem(Message("there is nothing to set; PATH=JSON or --loop-waves is needed"))
    if options.loop_waves and options.frame is not None:
        raise UsageProblem(Message("--loop-waves is for the whole cut and goes without --frame"))
    if options.ease and (options.frame is None or options.interp is not None):
        raise UsageProblem(Message("--ease is for the way to a key: it needs --frame, and goes without --interp"))
    if options.interp is not None and options.frame is None:
        raise UsageProblem(Message("--interp says how a key goes on and needs --frame"))


def _key(options: Namespace) -> "AsKey | None":
    """Return the key that values become; None where they hold for the whole cut."""
    from kagezou.animation.track import Interpolation
    from kagezou.document.spoken import AsKey

    if options.frame is None:
        return None
    return AsKey(options.frame, None if options.interp is None else Interpolation(options.interp), options.ease)


def _canvas_first(assignments: list[str]) -> tuple[list[tuple["CutWord", str]], list[str]]:
    """Return what is said of the cut itself, and the other assignments."""
    from kagezou.document.cut_words import cut_word_at

    on_canvas: list[tuple[CutWord, str]] = []
    others: list[str] = []
    for text in assignments:
        path, sign, value = text.partition("=")
        word = cut_word_at(path.strip()) if sign else None
        if word is None:
            others.append(text)
        else:
            on_canvas.append((word, value.strip()))
    return on_canvas, others


def _cut_set(document: "Document", words: list[tuple["CutWord", str]], options: Namespace) -> "Document":
    """Return the document with other settings of the cut, and say what comes of them."""
    from kagezou.document.refitting import Refit
    from kagezou.document.spoken import with_cut_words
    from kagezou.document.value_words import value_of_text

    if options.drawings is not None and not any(word.path == "canvas.size" for word, _ in words):
        raise UsageProblem(Message("--drawings says what becomes of drawings on another canvas.size, which is needed"))
    if words and options.frame is not None:
        raise UsageProblem(Message("{path} is the same on every frame and has no keys", path=words[0][0].path))
    said = ((word, value_of_text(word.path, text) if text[:1] in ('"', "[") else text) for word, text in words)
    changed = with_cut_words(document, said, Refit(options.drawings or Refit.CENTRE))
    for sentence in changed.notes:
        note(sentence)
    return changed.document


def _looping(document: "Document") -> "Document":
    """Return the document with waves that come back after the cut, and say how fast they go."""
    from kagezou.document.wave_edits import has_waves, loop_waves, loops_said

    figures = [layer for layer in document.layers if layer.joins is None]
    waved = tuple(layer.id for layer in figures if has_waves(layer.tracks, 1))
    document = loop_waves(document, waved, 1)
    for layer_id in waved:
        for sentence in loops_said(document, layer_id):
            note(sentence)
    if not waved:
        note(Message("no shadow lies on waves"))
    return document


def _assigned(document: "Document", text: str, key: "AsKey | None") -> "Document":
    """Return the document after ``PATH=JSON``; a layer's name may hold an equals sign."""
    from kagezou.document.address import resolve
    from kagezou.document.spoken import knows, put
    from kagezou.document.value_words import value_of_text

    halves = list(_halves(text))
    for path, value in halves:
        if knows(document, path):
            return put(document, path, value_of_text(path, value), key)
    if halves:
        resolve(document, halves[0][0])  # It says which path is near.
    raise UsageProblem(Message("{text!r} is not PATH=JSON, such as light.position=1400,-300,900", text=text))


def _halves(text: str) -> Iterator[tuple[str, str]]:
    """Yield the parts before and after each equals sign."""
    at = text.find("=")
    while at > 0:
        yield text[:at].strip(), text[at + 1 :].strip()
        at = text.find("=", at + 1)
