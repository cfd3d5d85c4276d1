"""``kagezou video``: the cut as a video."""

from argparse import Namespace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from kagezou.cli.after import add_after, hand_on_export
from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.interruption import stopping_gently
from kagezou.cli.standing_in import add_missing, missing_of
from kagezou.cli.terminal import give, give_json, note, tell
from kagezou.io.files.processors import processors

if TYPE_CHECKING:
    from kagezou.export.video import VideoSummary

DESCRIPTION = """\
Write the finished picture as a video: .mp4 is H.264 to look at, .mov is ProRes 4444 with alpha, both in BT.709. With
--layer it shows one layer's shadow alone. The file is there as a whole or not at all. Needs PyAV:
pip install av. Prints the file."""
EXAMPLES = """\
  kagezou video walk.kage -o preview.mp4
  kagezou video walk.kage -o preview.mp4 --frames 1-48
  kagezou video walk.kage -o hero_shadow.mov --layer Hero
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE", help="an .mp4 or .mov")
    parser.add_argument("--frames", metavar="LIST", help="such as 1-48 or 3,7,10-20 (the whole cut)")
    parser.add_argument("--layer", metavar="NAME", help="only the shadow of this layer")
    parser.add_argument("--workers", type=whole_number, metavar="N", help="threads that read and convert pictures")
    add_missing(parser)
    add_after(parser)
    parser.add_argument("--json", action="store_true", help="print one object about what was done")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Write the video."""
    from kagezou.animation.frames import parse_frames
    from kagezou.export.after.hooks import check_command
    from kagezou.export.after.manifest import Handover
    from kagezou.export.exporters.video_file import VIDEO_FILE
    from kagezou.export.video import VideoRequest
    from kagezou.io.project.file import load
    from kagezou.scene.heavy_sets import heavy_words

    check_command(options.after)
    request = VideoRequest(
        path=options.output,
        frames=None if options.frames is None else parse_frames(options.frames),
        layer=options.layer,
        workers=options.workers or processors(),
        missing=missing_of(options),
    )
    with stopping_gently() as interruption:
        with entry_points.line("filming") as line:
            document = load(options.project)
            if (words := heavy_words(document)) is not None:
                note(words)
            done = VIDEO_FILE.export(document, request, entry_points.open_context, line.update, interruption.is_set)
        _report(done, as_json=options.json)
        if not done.is_whole:
            return interruption.exit_code
        files = VIDEO_FILE.made_files(done)
        over = partial(Handover, VIDEO_FILE.key, document, options.project, files, is_whole=True, notes=done.notes)
        if not hand_on_export(over, options.after, interruption.is_set):
            return interruption.exit_code
    return 0


def _report(done: "VideoSummary", *, as_json: bool) -> None:
    """Print the file, or one object; notes, and that it was stopped, go to stderr."""
    from kagezou.io.files.faults import shown

    for sentence in done.notes:
        note(sentence)
    if not done.is_whole:
        tell("stopped; the video is not written")
    elif as_json:
        give_json({
            "file": shown(done.path),
            "frames": done.frames,
            "notes": [str(each) for each in done.notes],
            "seconds": round(done.seconds, 3),
        })  # fmt: skip
    else:
        give(shown(done.path))
