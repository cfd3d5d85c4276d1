"""Timesheets written as XDTS, as OpenToonz writes them."""

import json
from pathlib import Path
from typing import Final

from kagezou.io.files.atomic import write_bytes
from kagezou.io.sheets.timesheet import Timesheet
from kagezou.io.sheets.xdts import CELS, EMPTY_CEL, FIRST_LINE

_VERSION: Final = 5


def xdts_text(sheet: Timesheet) -> str:
    """Return a timesheet as the text of an XDTS file, as OpenToonz writes it.

    A column that does not begin on the first frame begins with an empty cel; columns without a name have an empty one,
    so that the others keep their places.
    """
    tracks = []
    for number, track in enumerate(sheet.tracks):
        entries = track.entries
        if entries and entries[0][0] > 0:
            entries = ((0, None), *entries)
        if entries:
            frames = [
                {"frame": frame, "data": [{"id": 0, "values": [EMPTY_CEL if cel is None else cel]}]}
                for frame, cel in entries
            ]
            tracks.append({"trackNo": number, "frames": frames})
    table = {
        "name": sheet.name,
        "duration": sheet.length_frames,
        "timeTableHeaders": [{"fieldId": CELS, "names": [track.name for track in sheet.tracks]}],
        "fields": [{"fieldId": CELS, "tracks": tracks}],
    }
    tree = {"header": {"cut": "1", "scene": "1"}, "timeTables": [table], "version": _VERSION}
    return f"{FIRST_LINE}\n{json.dumps(tree, ensure_ascii=False, indent=1)}\n"


def write_xdts(path: Path, sheet: Timesheet) -> None:
    """Write a timesheet as XDTS, as a whole or not at all.

    Raises
    ------
    DiskFullProblem, OutputProblem
        It cannot be written.
    """
    # Names of files may hold what no UTF-8 text can.
    write_bytes(path, xdts_text(sheet).encode("utf-8", "replace"))
