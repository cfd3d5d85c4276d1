"""What can be known before the first frame: drawings that are not there, a folder that refuses, a disk too small."""

import shutil
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import Final

from kagezou.errors import DiskFullProblem, InputProblem, UsageProblem
from kagezou.export.planning import FrameJob, Plan
from kagezou.export.request import ExportRequest
from kagezou.io.files.atomic import check_writable
from kagezou.io.files.faults import output_problem, shown
from kagezou.io.images.parts import has_part
from kagezou.io.sets.mesh_cache import is_mesh
from kagezou.message import Message
from kagezou.picture_source import PicturePart, PictureSource, file_of

LISTED: Final = 50
"""So many missing files are named in full; of more, the number is."""

_EMPTY_PART: Final = 500
_FILLED_PART: Final = 50
"""No encoder makes a picture smaller than this part of its pixels: a shadow, a composite."""


def missing_files(jobs: Iterable[FrameJob]) -> tuple[Path, ...]:
    """Return the drawings, backgrounds and sets that are needed and are not there, each once, in order of need."""
    needed = dict.fromkeys(path for job in jobs for path in job.content.sources.files)
    return tuple(path for path in needed if not _is_file(path))


def missing_parts(jobs: Iterable[FrameJob]) -> tuple[PicturePart, ...]:
    """Return the layers of files that are needed and are not in them, each once, in order of need.

    Raises
    ------
    InputProblem
        A file cannot be read at all.
    """
    needed = dict.fromkeys(
        each for job in jobs for each in job.content.sources.pictures if isinstance(each, PicturePart)
    )
    return tuple(part for part in needed if not has_part(part))


def missing_pictures(jobs: Iterable[FrameJob]) -> tuple[PictureSource, ...]:
    """Return the pictures that are needed and are not there, files and layers of files, each once, in order of need.

    Raises
    ------
    InputProblem
        A file of which a layer is needed cannot be read at all.
    """
    return missing_pictures_of(dict.fromkeys(each for job in jobs for each in job.content.sources.pictures))


def missing_pictures_of(sources: Iterable[PictureSource]) -> tuple[PictureSource, ...]:
    """Return those pictures that are not there, in their order; InputProblem as above."""
    return tuple(
        each
        for each in sources
        if not _is_file(file_of(each)) or (isinstance(each, PicturePart) and not has_part(each))
    )


def check_sources(jobs: Collection[FrameJob]) -> None:
    """Raise InputProblem that names every missing file, or every layer missing in one, in one sentence."""
    missing = [shown(path) for path in missing_files(jobs)]
    missing = missing or [f"{shown(part.path)} ({part.address})" for part in missing_parts(jobs)]
    if not missing:
        return
    if len(missing) == 1:
        if is_mesh(Path(missing[0])):
            raise InputProblem(Message("{path}: the set is missing", path=missing[0]))
        raise InputProblem(Message("{path}: the drawing is missing", path=missing[0]))
    listed: object = ", ".join(missing[:LISTED])
    if len(missing) > LISTED:
        listed = Message("{names} and {count} more", names=listed, count=len(missing) - LISTED)
    raise InputProblem(Message("{count} drawings are missing: {names}", count=len(missing), names=listed))


def check_targets(plan: Plan) -> None:
    """Raise UsageProblem where a file of the export would lie in the place of one that it is made of.

    Names are compared as file systems do that mind no case: a drawing lost is worse than a name refused.
    """
    needed = {str(path.absolute()).casefold() for job in plan.jobs for path in job.content.sources.files}
    for target in (target for job in plan.jobs for target in job.targets):
        if str(target.path.absolute()).casefold() in needed:
            raise UsageProblem(
                Message("{path}: it is a drawing of the project and is not written over", path=shown(target.path))
            )


def prepare_folders(request: ExportRequest, plan: Plan) -> None:
    """Make the folders of an export and see whether they can be written to.

    Raises
    ------
    DiskFullProblem, OutputProblem
        A folder cannot be made or written to, or the disk certainly has no room for the frames.
    """
    for folder in plan.folders:
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise output_problem(folder, error) from error
        check_writable(folder)
    needed = sum(_least_bytes(job, request) for job in plan.jobs)
    free = shutil.disk_usage(request.folder).free
    if needed > free:
        raise DiskFullProblem(
            Message(
                "{folder}: {files} files need at least {needed} MB, but only {free} MB are free on the disk",
                folder=shown(request.folder),
                files=plan.files,
                needed=needed >> 20,
                free=free >> 20,
            )
        )


def _least_bytes(job: FrameJob, request: ExportRequest) -> int:
    canvas = job.content.scene.canvas
    part = _FILLED_PART if job.content.is_filled else _EMPTY_PART
    return len(job.targets) * canvas.width * canvas.height * 4 * request.depth // 8 // part


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
