"""``kagezou timesheet``: the exposures of a project as a timesheet."""

from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser, project_path
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import give, note
from kagezou.message import Message

DESCRIPTION = """\
Write when which drawing is exposed as a digital timesheet (XDTS), a column for each layer, for Clip Studio Paint,
OpenToonz and others. Dialogue, camera work and marks of the sheet that timed the project come back in it. A file that
is there stays unless --force replaces it: it may hold newer ones. Prints the file."""
EXAMPLES = """\
  kagezou timesheet cut12.kage -o cut12.xdts
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("-o", "--output", type=Path, required=True, metavar="FILE.xdts", help="the timesheet")
    parser.add_argument("--force", action="store_true", help="replace a timesheet that is there")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Write the timesheet."""
    from kagezou.errors import OutputProblem, UsageProblem
    from kagezou.importing.timesheet_on_document import sheet_of
    from kagezou.io.files.faults import shown
    from kagezou.io.project.file import load
    from kagezou.io.sheets.xdts_writing import notes_on_head, write_xdts

    project: Path = options.project
    output: Path = options.output
    if output.suffix.lower() != ".xdts":
        raise UsageProblem(Message("{output}: a timesheet is written as .xdts", output=shown(output)))
    if output.exists() and not options.force:
        raise OutputProblem(Message("{output}: it is there already; --force replaces it", output=shown(output)))
    sheet = sheet_of(load(project), project.stem)
    write_xdts(output, sheet)
    for sentence in notes_on_head(sheet):
        note(sentence)
    give(shown(output))
    return 0
