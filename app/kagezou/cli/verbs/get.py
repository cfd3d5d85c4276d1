"""``kagezou get``: the value of one property as JSON."""

from argparse import Namespace

from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give_json

DESCRIPTION = """\
Print the value of a property as JSON: with --frame the value there, else the constant, or the list of its keys.
The tilt of a layer with two grounding points is measured: what is shown on the frame, or on the first one."""
EXAMPLES = """\
  kagezou get walk.kage light.position
  kagezou get walk.kage layers.Hero.shadow.opacity --frame 12
  kagezou get walk.kage light.position --json        with its path, unit and keys
"""


def add_arguments(parser: Parser) -> None:
    """Say what can be typed."""
    parser.add_argument("project", type=project_path, metavar="PROJECT.kage", help="the project file")
    parser.add_argument("path", metavar="PATH", help="a property; kagezou info PROJECT.kage --properties lists them")
    parser.add_argument("--frame", type=whole_number, metavar="N", help="the frame, counted from 1")
    parser.add_argument("--json", action="store_true", help="one object with path, unit, frame, value and keys")


def run(options: Namespace, entry_points: EntryPoints) -> int:  # noqa: ARG001 - every verb is called alike
    """Load the project and print the value."""
    from kagezou.document.value_words import json_of_keys, json_of_value
    from kagezou.io.project.file import load
    from kagezou.scene.spoken_values import spoken_value

    found = spoken_value(load(options.project), options.path, options.frame)
    value = None if found.value is None else json_of_value(found.value)
    keys = json_of_keys(found.keys)
    if not options.json:
        give_json(keys if value is None else value)
        return 0
    about: dict[str, Json] = {"path": options.path, "unit": found.unit, "frame": options.frame}
    give_json(about | {"value": value, "keys": keys} | ({"measured": True} if found.is_measured else {}))
    return 0
