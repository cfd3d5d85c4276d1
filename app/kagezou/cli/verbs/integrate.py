"""``kagezou integrate``: a place in the menus of a Linux desktop, for the program and for its files."""

import sys
from argparse import Namespace
from pathlib import Path

from kagezou.cli.arguments import Parser
from kagezou.cli.desktop_files import DesktopFiles
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import give
from kagezou.errors import UsageProblem
from kagezou.message import Message
from kagezou.own_process import program_words

DESCRIPTION = """\
Tell a Linux desktop of the program: an entry in its menus, projects (.kage) that open with it, icons, and small
pictures of projects in file managers. Everything goes into the user's own folders; --remove takes it away. Prints the
files."""
EXAMPLES = """\
  kagezou integrate
  kagezou integrate --remove
  kagezou integrate --into /usr/share --program /usr/bin/kagezou        for all users, as a package does it
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("--remove", action="store_true", help="take it all away again")
    parser.add_argument("--into", type=Path, metavar="DIR", help="the folder of shared data (~/.local/share)")
    parser.add_argument("--program", metavar="FILE", help="how the program is called (this one)")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Write the files, or take them away."""
    if not sys.platform.startswith("linux"):
        raise UsageProblem(Message("this is for Linux; elsewhere the installer does it"))
    from kagezou.io.files.faults import shown

    share = options.into or _users_share()
    files = DesktopFiles(share, (options.program,) if options.program else program_words())
    done = files.remove() if options.remove else files.write()
    if options.into is None:
        files.bring_lists_up_to_date()
    give("\n".join(shown(path) for path in done))
    return 0


def _users_share() -> Path:
    from platformdirs import user_data_path

    return user_data_path()
