"""Render jobs for farms: an Open Job Description job bundle, which Deadline Cloud takes as it is.

The bundle is three JSON files: the template, the values of its parameters, and the files that go with the job. See
https://github.com/OpenJobDescription/openjd-specifications, revision 2023-09 with the extension TASK_CHUNKING.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from kagezou.animation.frames import format_frames
from kagezou.document.model import Document
from kagezou.errors import UsageProblem
from kagezou.export.planning import PIXEL_BYTES, planned
from kagezou.export.request import DEPTHS, LAYERED_SUFFIXES, SUFFIXES, ExportRequest
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem
from kagezou.io.sets.gltf import files_beside
from kagezou.message import Message

TEMPLATE: Final = "template.json"
PARAMETERS: Final = "parameter_values.json"
ASSETS: Final = "asset_references.json"
MAX_CHUNK: Final = 10_000
MAX_MINUTES: Final = 1440

AUTO_DEPTH: Final = "auto"
"""The depth that follows the format."""

_NAME_CHARACTERS: Final = 64
_PLACES, _FRAMES = "Places", "Frames"
_LEAST_CORES: Final = 2
_PROGRAM_MIB: Final = 1024
_MIB_STEP: Final = 512
_STARTING_S: Final = 600
"""So long a worker may take until the first frame is begun, with drawings on slow disks and OpenGL to be opened."""
NOTICE_S: Final = 60
"""So long a task that is stopped has for the frames that it has begun."""

Json = dict[str, Any]


@dataclass(frozen=True, slots=True)
class FarmRequest:
    """What a farm is to make.

    Parameters
    ----------
    project
        The project file, absolute.
    export
        As of a local export; its folder is the job's output, absolute.
    chunk
        How many frames one task has: a task opens OpenGL once.
    program
        How the program is called on the workers.
    frame_minutes
        How long a frame may take before a task is taken for stuck.
    """

    project: Path
    export: ExportRequest
    chunk: int = 10
    program: str = "kagezou"
    frame_minutes: int = 10

    def __post_init__(self) -> None:
        if not 1 <= self.chunk <= MAX_CHUNK:
            raise UsageProblem(
                Message("a task has 1 to {most_chunk} frames, not {chunk}", most_chunk=MAX_CHUNK, chunk=self.chunk)
            )
        if not 1 <= self.frame_minutes <= MAX_MINUTES:
            raise UsageProblem(
                Message(
                    "a frame may take 1 to {most_minutes} minutes, not {minutes}",
                    most_minutes=MAX_MINUTES,
                    minutes=self.frame_minutes,
                )
            )


def write_bundle(document: Document, request: FarmRequest, folder: Path) -> tuple[Path, ...]:
    """Write a job bundle into a folder, which is made if need be, and return its files.

    Raises
    ------
    UsageProblem
        The request does not fit the document.
    DiskFullProblem, OutputProblem
        A file cannot be written.
    """
    planned(document, request.export)
    trees = {
        TEMPLATE: template(document, request),
        PARAMETERS: {"parameterValues": _values(document, request)},
        ASSETS: {"assetReferences": _assets(document, request)},
    }
    return write_job(trees, folder)


def write_job(trees: Mapping[str, Json], folder: Path) -> tuple[Path, ...]:
    """Write the files of a bundle, JSON by name, into a folder, which is made if need be, and return them.

    Raises
    ------
    DiskFullProblem, OutputProblem
        A file cannot be written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    for name, tree in trees.items():
        write_bytes(folder / name, (json.dumps(tree, indent=2, ensure_ascii=False) + "\n").encode("utf-8"))
    return tuple(folder / name for name in trees)


def template(document: Document, request: FarmRequest) -> Json:
    """Return the job template; frames, output, format and program stay parameters of the job."""
    return {
        "specificationVersion": "jobtemplate-2023-09",
        "extensions": ["TASK_CHUNKING"],
        "name": job_name(request.project.stem),
        "parameterDefinitions": _definitions(document, request),
        "steps": [
            {
                "name": "Render",
                "parameterSpace": {
                    "taskParameterDefinitions": [
                        {
                            "name": "Frame",
                            "type": "CHUNK[INT]",
                            "range": "{{Param.Frames}}",
                            "chunks": {"defaultTaskCount": request.chunk, "rangeConstraint": "CONTIGUOUS"},
                        }
                    ]
                },
                "hostRequirements": _host_requirements(document),
                "script": {"actions": {"onRun": _action(request)}},
            }
        ],
    }


def _action(request: FarmRequest) -> Json:
    """Return the command of a task, how long it may take, and how it is stopped: the program ends between frames."""
    return {
        "command": "{{Param.Program}}",
        "args": _words(request),
        "timeout": _STARTING_S + 60 * request.frame_minutes * request.chunk,
        "cancelation": {"mode": "NOTIFY_THEN_TERMINATE", "notifyPeriodInSeconds": NOTICE_S},
    }


def _words(request: FarmRequest) -> list[str]:
    export = request.export
    words = ["render", "{{Param.ProjectFile}}", "-o", "{{Param.OutputDir}}", "--frames", "{{Task.Param.Frame}}"]
    words += ["--format", "{{Param.Format}}", "--depth", "{{Param.Depth}}"]
    words += ["--path-mapping", "{{Session.PathMappingRulesFile}}", "--skip-existing", "--openjd"]
    for layer in export.layers or ():
        if "{{" in layer:
            raise UsageProblem(Message("the layer {layer!r} cannot be named in a job: it has braces", layer=layer))
        words += ["--layer", layer]
    switches = {
        "--united": export.united,
        "--composite": export.composite,
        "--layered": export.layered,
        "--receivers": export.receivers,
    }
    return words + [switch for switch, is_on in switches.items() if is_on]


def _definitions(document: Document, request: FarmRequest) -> list[Json]:
    """Return what may be given to a job: places first, then how its frames are made."""
    return [*_places(), *_settings(document, request)]


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


def _settings(document: Document, request: FarmRequest) -> list[Json]:
    length, export = document.canvas.length_frames, request.export
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
        {
            "name": "Program",
            "type": "STRING",
            "default": request.program,
            "userInterface": shown_as("LINE_EDIT", "Program", "Workers"),
            "description": "How Kagezou is called on the workers: a name, or the path of the program.",
        },
    ]


def shown_as(control: str, label: str, group: str) -> Json:
    """Return what a window for sending jobs shows a parameter as."""
    return {"control": control, "label": label, "groupLabel": group}


def _host_requirements(document: Document) -> Json:
    """Return what a worker must have: memory for whole pictures of the canvas, and what the program takes besides."""
    canvas = document.canvas
    needed = _PROGRAM_MIB + canvas.width_px * canvas.height_px * PIXEL_BYTES // (1 << 20)
    return {
        "amounts": [
            {"name": "amount.worker.vcpu", "min": _LEAST_CORES},
            {"name": "amount.worker.memory", "min": -(-needed // _MIB_STEP) * _MIB_STEP},
        ]
    }


def _values(document: Document, request: FarmRequest) -> list[Json]:
    frames = request.export.frames or tuple(range(1, document.canvas.length_frames + 1))
    return [
        {"name": "ProjectFile", "value": str(request.project)},
        {"name": "OutputDir", "value": str(request.export.folder)},
        {"name": "Frames", "value": format_frames(frames)},
    ]


def _assets(document: Document, request: FarmRequest) -> Json:
    """Return what must be there on a worker: the project, every picture it shows and every set."""
    pictures = {drawing.path for layer in document.layers for drawing in layer.cels.drawings}
    pictures |= {drawing.path for drawing in document.behind.drawings}
    for piece in document.pieces:
        if piece.source is not None:
            pictures |= {piece.source, *files_beside(piece.source)}
    return {
        "inputs": {"filenames": [str(request.project), *sorted(map(str, pictures))], "directories": []},
        "outputs": {"directories": [str(request.export.folder)]},
        "referencedPaths": [],
    }


def job_name(stem: str) -> str:
    """Return a name for a job without what the specification forbids: braces, which are filled in, and controls."""
    name = "".join(sign if sign.isprintable() and sign not in "{}" else "_" for sign in stem)
    return f"Kagezou {name}"[:_NAME_CHARACTERS]
