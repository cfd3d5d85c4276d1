"""``kagezou thumbnail``: a small picture of a project, for file managers."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.errors import InputProblem
from kagezou.message import Message

DESCRIPTION = "Draw the first frame of a project small, as PNG on white. File managers call it; see kagezou integrate."
EXAMPLES = """\
  kagezou thumbnail walk.kage -o walk.png
  kagezou thumbnail walk.kage -o walk.png --size 512
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE", help="the picture")
    parser.add_argument("--size", type=whole_number, default=256, metavar="PX", help="its longer side at most (256)")


def run(options: Namespace, entry_points: EntryPoints) -> int:
    """Draw the picture and write it."""
    from kagezou.export.shrinking import shrunk
    from kagezou.export.small_first_frame import first_frame
    from kagezou.io.files.atomic import write_bytes
    from kagezou.io.files.faults import shown
    from kagezou.io.images.writing import encode_rgba_png
    from kagezou.io.project.file import load

    document = load(options.project)
    with entry_points.open_context():
        picture = first_frame(document)
    if picture is None:
        raise InputProblem(
            Message("{path}: its first frame is too large for a small picture", path=shown(options.project))
        )
    write_bytes(options.output, encode_rgba_png(shrunk(picture, options.size)))
    return 0
