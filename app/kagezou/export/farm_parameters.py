"""What may be given to a job of a render farm when it is sent: the parameters of its template."""

from typing import Any, Final

from kagezou.animation.frames import format_frames
from kagezou.document.model import Document
from kagezou.export.request import DEPTHS, LAYERED_SUFFIXES, SUFFIXES, ExportRequest, Missing

AUTO_DEPTH: Final = "auto"
"""The depth that follows the format."""

_PLACES, _FRAMES = "Places", "Frames"

Json = dict[str, Any]


def definitions(document: Document, export: ExportRequest, program: str) -> list[Json]:
    """Return what may be given to a job: places first, then how its frames are made.

    Parameters
    ----------
    document, export
        What the job renders.
    program
        How the program is called on the workers, unless the job says otherwise.
    """
    return [*_places(), *_settings(document, export, program)]


def _places() -> list[Json]:
    return [
        {
            "name": "ProjectFile",
            "type": "PATH",
            "objectType": "FILE",
            "dataFlow": "IN",
            "userInterface": {
                "control": "CHOOSE_INPUT_FILE",
                "label": "Project",
                "groupLabel": _PLACES,
                "fileFilters": [{"label": "Kagezou projects", "patterns": ["*.kage"]}],
            },
            "description": "The Kagezou project.",
        },
        {
            "name": "OutputDir",
            "type": "PATH",
            "objectType": "DIRECTORY",
            "dataFlow": "OUT",
            "userInterface": shown_as("CHOOSE_DIRECTORY", "Output folder", _PLACES),
            "description": "Where the shadow layers go.",
        },
    ]


def _settings(document: Document, export: ExportRequest, program: str) -> list[Json]:
    length = document.canvas.length_frames
    own = export.depth == DEPTHS[export.format][0]
    return [
        {
            "name": "Frames",
            "type": "STRING",
            "default": format_frames(export.frames or tuple(range(1, length + 1))),
            "userInterface": shown_as("LINE_EDIT", "Frames", _FRAMES),
            "description": "Frames such as 1-48, 1-10,20 or 1-48:2.",
        },
        {
            "name": "Format",
            "type": "STRING",
            "default": export.format,
            "allowedValues": list(LAYERED_SUFFIXES if export.layered else SUFFIXES),
            "userInterface": shown_as("DROPDOWN_LIST", "Format", _FRAMES),
            "description": "The format of the frames.",
        },
        {
            "name": "Depth",
            "type": "STRING",
            "default": AUTO_DEPTH if own else str(export.depth),
            "allowedValues": [AUTO_DEPTH, *map(str, sorted({depth for each in DEPTHS.values() for depth in each}))],
            "userInterface": shown_as("DROPDOWN_LIST", "Bits a channel", _FRAMES),
            "description": "Bits a channel; auto is what the format usually has. exr has 16, tga 8.",
        },
        _missing(export),
        {
            "name": "Program",
            "type": "STRING",
            "default": program,
            "userInterface": shown_as("LINE_EDIT", "Program", "Workers"),
            "description": "How Kagezou is called on the workers: a name, or the path of the program.",
        },
    ]


def _missing(export: ExportRequest) -> Json:
    return {
        "name": "Missing",
        "type": "STRING",
        "default": export.missing.value,
        "allowedValues": [each.value for each in Missing],
        "userInterface": shown_as("DROPDOWN_LIST", "Missing drawings", _FRAMES),
        "description": "fail makes nothing; empty leaves these frames empty, hold shows the nearest drawing.",
    }


def shown_as(control: str, label: str, group: str) -> Json:
    """Return what a window for sending jobs shows a parameter as."""
    return {"control": control, "label": label, "groupLabel": group}
