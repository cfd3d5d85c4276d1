"""``kagezou timesheet``: the exposures of a project as a timesheet."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.doors import Doors
from kagezou.cli.terminal import give

DESCRIPTION = """\
Write when which drawing is exposed as a digital timesheet (XDTS), a column for each layer, for Clip Studio Paint,
OpenToonz and others. Prints the file."""
EXAMPLES = """\
  kagezou timesheet cut12.kage -o cut12.xdts
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE.xdts", help="the timesheet")


def run(options: Namespace, doors: Doors) -> int:  # noqa: ARG001 - every verb is called alike
    """Write the timesheet."""
    from kagezou.io.faults import shown
    from kagezou.io.project_file import load
    from kagezou.io.xdts import write_xdts
    from kagezou.session.timing import sheet_of

    project: Path = options.project
    write_xdts(options.output, sheet_of(load(project), project.stem))
    give(shown(options.output))
    return 0
