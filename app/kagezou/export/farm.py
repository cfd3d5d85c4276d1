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
from kagezou.export.farm_parameters import definitions
from kagezou.export.file_names import USUAL, FileNames
from kagezou.export.planning import PIXEL_BYTES, planned
from kagezou.export.request import ExportRequest, Missing
from kagezou.io.files.atomic import write_bytes
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.files.folders import entries_to_write
from kagezou.io.sets.gltf import files_beside
from kagezou.message import Message

TEMPLATE: Final = "template.json"
PARAMETERS: Final = "parameter_values.json"
ASSETS: Final = "asset_references.json"
_FILES: Final = (TEMPLATE, PARAMETERS, ASSETS)
MAX_CHUNK: Final = 10_000
MAX_MINUTES: Final = 1440

_NAME_CHARACTERS: Final = 64
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
        The request does not fit the document, or the folder holds something else.
    DiskFullProblem, OutputProblem
        A file cannot be written.
    """
    planned(document, request.export)
    trees = {
        TEMPLATE: template(document, request),
        PARAMETERS: {"parameterValues": _values(document, request)},
        ASSETS: {"assetReferences": _assets(document, request)},
    }
    return write_job(trees, folder, request.export.folder)


def write_job(trees: Mapping[str, Json], folder: Path, output: Path) -> tuple[Path, ...]:
    """Write the files of a bundle, JSON by name, into a folder, which is made if need be, and return them.

    Parameters
    ----------
    trees
        JSON by the names of the three files.
    folder
        Where they go.
    output
        Where the job writes.

    Raises
    ------
    UsageProblem
        The folder holds something else.
    DiskFullProblem, OutputProblem
        A file cannot be written.
    """
    _check_folder(folder, output)
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise output_problem(folder, error) from error
    for name, tree in trees.items():
        write_bytes(folder / name, (json.dumps(tree, indent=2, ensure_ascii=False) + "\n").encode("utf-8"))
    return tuple(folder / name for name in trees)


def _check_folder(folder: Path, output: Path) -> None:
    """Refuse a folder that holds anything but a bundle, such as frames: whoever sends a bundle sends all of it."""
    others = [each for each in entries_to_write(folder) if each.name not in _FILES]
    seen = sorted(each.name for each in others if not each.name.startswith("."))
    if folder.absolute() == output.absolute():
        raise UsageProblem(
            Message("{folder}: the job renders there; its bundle needs a folder of its own", folder=shown(folder))
        )
    if seen:
        raise UsageProblem(
            Message(
                "{folder}: it holds {name}, which is no part of a bundle; a bundle needs a folder of its own",
                folder=shown(folder),
                name=seen[0],
            )
        )


def template(document: Document, request: FarmRequest) -> Json:
    """Return the job template; frames, output, format and program stay parameters of the job."""
    return {
        "specificationVersion": "jobtemplate-2023-09",
        "extensions": ["TASK_CHUNKING"],
        "name": job_name(request.project.stem),
        "parameterDefinitions": definitions(document, request.export, request.program),
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
    words += ["--missing", "{{Param.Missing}}"]
    words += ["--path-mapping", "{{Session.PathMappingRulesFile}}", "--skip-existing", "--openjd"]
    words += _naming(export.names)
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


def _naming(names: FileNames) -> list[str]:
    """Return the words that say how files are called, where that is not as usual."""
    words = [] if names.pattern == USUAL else ["--names", names.pattern]
    words += [] if names.first is None else ["--start-frame", str(names.first)]
    return words if names.digits is None else [*words, "--padding", str(names.digits)]


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
    if request.export.missing is not Missing.FAIL:
        # Who sends a job refuses one that names files which are not there.
        pictures = {path for path in pictures if path.exists()}
    return {
        "inputs": {"filenames": [str(request.project), *sorted(map(str, pictures))], "directories": []},
        "outputs": {"directories": [str(request.export.folder)]},
        "referencedPaths": [],
    }


def job_name(stem: str) -> str:
    """Return a name for a job without what the specification forbids: braces, which are filled in, and controls."""
    name = "".join(sign if sign.isprintable() and sign not in "{}" else "_" for sign in stem)
    return f"Kagezou {name}"[:_NAME_CHARACTERS]
