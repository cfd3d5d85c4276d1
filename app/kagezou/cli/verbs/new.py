"""``kagezou new``: a project of character drawings, with a light that shows a good shadow at once."""

from argparse import Namespace
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, frame_rate, named_part, named_source, project_path, size
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.holding import held_project
from kagezou.cli.terminal import note
from kagezou.errors import OutputProblem, UsageProblem
from kagezou.message import Message

if TYPE_CHECKING:
    from kagezou.document.model import Document
    from kagezou.importing.imported import Imported
    from kagezou.importing.new_cels import CharacterSource
    from kagezou.picture_source import PicturePart

DESCRIPTION = """\
Make a project. A character is a folder of numbered drawings, a pattern such as 'walk_#.png', one picture, or a PSD file
with a group of numbered layers; a background is one picture, or such a folder or pattern."""
_BACKGROUND = "background"
EXAMPLES = """\
  kagezou new walk.kage --character Hero=drawings/hero
  kagezou new walk.kage --character Hero=drawings/body --cel Hero=arm=drawings/arm
  kagezou new duo.kage --character A=cels/A --character B=cels/B --background street.png
  kagezou new run.kage --character A=cels/A --background 'bg/street_#.png'
  kagezou new shot.kage --character A=cels/A --background set.exr --layer background=diffuse
  kagezou new cut12.kage --timesheet cut12/cut12.xdts
  kagezou new cut12.kage --psd cut12.psd
  kagezou new cut12.kage --oca cut12.oca
  kagezou new cut12.kage --character A=cels/A --timesheet cut12.xdts --fps 24 --size 1920x1080
  kagezou new cut12.kage --character A=cels/A --template show.kage
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    _add_sources(parser)
    _add_whole_files(parser)
    parser.add_argument("--background", type=Path, metavar="DIR_OR_FILE", help="the pictures under everything")
    parser.add_argument(
        "--timesheet",
        type=Path,
        metavar="SHEET.xdts",
        help="when which drawing is exposed (also .tdts, .sts); without --character its columns find their drawings",
    )
    parser.add_argument("--size", type=size, metavar="WxH", help="the canvas in px; else that of the pictures")
    parser.add_argument("--fps", type=frame_rate, metavar="RATE", help="frames a second (24, or as an OCA file says)")
    parser.add_argument(
        "--template",
        type=project_path,
        metavar="FROM.kage",
        help="a project whose canvas, rate, light, looks, ground and set the new one gets",
    )
    parser.add_argument(
        "--values",
        type=Path,
        metavar="FILE.json",
        help="properties from the start, such as where figures lie, so that ground and light fit them: an object of "
        "PATHs, each with its value or, as in a project file, its keys",
    )
    parser.add_argument("--no-feet", action="store_true", help="do not look for feet; kagezou feet does so later")
    parser.add_argument("--force", action="store_true", help="replace a project that is there")


def _add_sources(parser: Parser) -> None:
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file to write")
    parser.add_argument(
        "--character",
        type=named_source,
        action="append",
        default=[],
        metavar="NAME=DIR_OR_FILE",
        help="a character layer; may be given several times, from the lowest to the topmost",
    )
    parser.add_argument(
        "--cel",
        type=named_part,
        action="append",
        dest="character",
        metavar="CHARACTER=NAME=DIR_OR_FILE",
        help="one more cel of a character, such as an arm, over what was named before: one figure, one shadow",
    )
    parser.add_argument(
        "--layer",
        action="append",
        default=[],
        metavar="[CHARACTER=]NAME",
        help="which layer of OpenEXR files is the drawing, of all or of one character; of 'background' that under "
        "everything; else the beauty",
    )
    parser.add_argument(
        "--sheet", metavar="NAME_OR_NUMBER", help="which sheet of a timesheet file that holds several (the first)"
    )


def _add_whole_files(parser: Parser) -> None:
    parser.add_argument(
        "--psd",
        type=Path,
        action="append",
        default=[],
        metavar="FILE.psd",
        help="a PSD file with everything in it: groups of numbered layers become characters, a layer named "
        "'BG' the background; a timesheet beside it with the same name times it",
    )
    parser.add_argument(
        "--oca",
        type=Path,
        action="append",
        default=[],
        metavar="FILE.oca",
        help="a document of Open Cel Animation with everything in it: its layers become characters, groups of several "
        "figures, a lowest layer that fills the canvas the background; canvas, rate and length are the cut's",
    )


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Make the project and write it."""
    from kagezou.importing.understood import understood
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import save

    path: Path = options.project
    if path.suffix.lower() != ".kage":
        raise UsageProblem(
            Message(
                "{path}: the name of a project ends in .kage, such as {better}",
                path=shown(path),
                better=shown(path.with_name(f"{path.name}.kage")),
            )
        )
    if path.exists() and not options.force:
        raise OutputProblem(Message("{path}: it is there already; --force replaces it", path=shown(path)))
    imported = _brought(options)
    document = imported.document
    if not document.layers and document.background is None:
        raise UsageProblem(
            Message("{path}: not made, as there is no character and no background in it", path=shown(path))
        )
    notes = [*understood(document), *imported.notes]
    if options.values is not None:
        document = _with_values(document, options.values)
    if not options.no_feet:
        found = _on_feet(document, entry_points)
        document = found.document
        notes += found.notes
    if path.exists():
        with held_project(path):
            save(document, path)
    else:
        save(document, path)
    for sentence in notes:
        note(sentence)
    return 0


def _brought(options: Namespace) -> "Imported":
    """Return the document of all that was named, timed by a sheet where there is one."""
    from kagezou.importing.new_cut import NewCut, columns_of, new_cut
    from kagezou.importing.staging import CharacterSource
    from kagezou.io.project.file import load

    is_timed = options.timesheet is not None
    sources = [CharacterSource(name, source, is_timed, *figure) for name, source, *figure in options.character]
    sources += [CharacterSource(None, source) for source in (*options.psd, *options.oca)]
    if is_timed and not sources:
        sources = list(columns_of(options.timesheet, options.sheet))
    sources, background = _of_layers(sources, options.background, options.layer)
    template = None if options.template is None else load(options.template)
    wanted = NewCut(background, options.timesheet, options.sheet, options.size, options.fps, template)
    imported = new_cut(sources, wanted)
    _check_layers(imported.document, options.layer)
    return imported


def _of_layers(
    sources: "list[CharacterSource]", background: Path | None, layers: Sequence[str]
) -> "tuple[list[CharacterSource], Path | PicturePart | None]":
    """Return the sources with the layers that are taken of their OpenEXR files."""
    from kagezou.picture_source import PicturePart

    behind: Path | PicturePart | None = background
    for text in layers:
        who, sign, name = text.rpartition("=")
        known = {_BACKGROUND, *(source.name for source in sources)}
        if sign and who not in known:
            raise UsageProblem(
                Message(
                    "--layer {text}: there is no character {who!r} and no background of that name", text=text, who=who
                )
            )
        sources = [replace(each, layer=name) if who in ("", each.name) else each for each in sources]
        if background is not None and who in ("", _BACKGROUND):
            behind = PicturePart(background, name)
    return sources, behind


def _check_layers(document: "Document", layers: Sequence[str]) -> None:
    """Raise UsageProblem where a layer was asked for and there is no OpenEXR file that it could be taken of."""
    drawings = [*document.behind.drawings, *(each for layer in document.layers for each in layer.cels.drawings)]
    for text in layers:
        if not any(each.part == text.rpartition("=")[2] for each in drawings):
            raise UsageProblem(Message("--layer {text}: none of the files is OpenEXR", text=text))


def _with_values(document: "Document", path: Path) -> "Document":
    """Return the document with the properties of a file; where these move figures, ground and light fit them there."""
    from kagezou.document.edits import set_track
    from kagezou.importing.lighting import grounded_as_shown
    from kagezou.io.clips.value_files import load_tracks
    from kagezou.scene.placing import PLACING

    tracks = load_tracks(path, document)
    are_moved = any(address.property.name in PLACING for address, _ in tracks)
    for address, track in tracks:
        document = set_track(document, address, track)
    if not are_moved:
        return document
    document = grounded_as_shown(document)
    # What the file says of ground and light is meant as it stands.
    for address, track in tracks:
        document = set_track(document, address, track)
    return document


def _on_feet(document: "Document", entry_points: EntryPoints) -> "Imported":
    """Return the document with the feet of all its layers."""
    from kagezou.importing.feet import document_with_feet

    ids = [layer.id for layer in document.layers]
    with entry_points.line("looking for feet") as line:
        return document_with_feet(document, ids, lambda _part, done, whole: line.update(done, whole))
