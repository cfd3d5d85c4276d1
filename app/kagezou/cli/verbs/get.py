"""``kagezou get``: the value of one property as JSON."""

from argparse import Namespace
from typing import TYPE_CHECKING

from kagezou.cli.arguments import Parser, project_path, whole_number
from kagezou.cli.entry_points import EntryPoints
from kagezou.cli.terminal import Json, give_json

if TYPE_CHECKING:
    from kagezou.document.address import Address
    from kagezou.document.model import Document

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
    from kagezou.document.cut_settings import CutSettings
    from kagezou.document.cut_words import cut_word_at
    from kagezou.document.whole_cut import saying_at
    from kagezou.io.project.file import load

    document = load(options.project)
    said = saying_at(document, options.path)
    about: dict[str, Json] = {"path": options.path, "unit": "", "frame": options.frame}
    word = cut_word_at(options.path)
    if word is not None:
        found = about | {"value": word.value(CutSettings.of(document)), "keys": []}
    elif said is None:
        found = about | _of_property(document, options.path, options.frame)
    else:
        found = about | {"value": said.value, "keys": []}
    if options.json:
        give_json(found)
    else:
        give_json(found["keys"] if found["value"] is None else found["value"])
    return 0


def _of_property(document: "Document", path: str, frame: int | None) -> dict[str, Json]:
    """Return unit, value and keys of a property; no value where it is keyed and no frame is asked for."""
    from kagezou.cli.values import json_of_keys, json_of_value
    from kagezou.document.address import resolve, track_of

    address = resolve(document, path)
    track = track_of(document, address)
    keys: Json = json_of_keys(track)
    measured = _measured_tilt(document, address, frame or 1)
    if measured is not None:
        return {"unit": address.property.unit, "value": measured, "keys": keys, "measured": True}
    value = json_of_value(track.constant) if frame is None else json_of_value(track.value_at(frame))
    is_list = track.is_keyed and frame is None
    return {"unit": address.property.unit, "value": None if is_list else value, "keys": keys}


def _measured_tilt(document: "Document", address: "Address", frame: int) -> float | None:
    """Return the angle that is shown where grounding points tell a body's tilt; None for all else."""
    from kagezou.document.properties import TILT
    from kagezou.scene.evaluate import camera_at, ground_at
    from kagezou.scene.figure_card import card_at

    if address.property is not TILT or address.layer_id is None:
        return None
    layer = document.layer(address.layer_id)
    card = card_at(document, layer, frame, camera_at(document, frame), ground_at(document, frame))
    return card.tilt_deg if card.is_tilt_measured else None
