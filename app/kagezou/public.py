"""What `import kagezou` gives: its names, and the OpenGL context that cuts are drawn with.

`docs/en/python.md` says what it promises; `tests/interface` holds its names and signatures.
"""

import warnings
from collections.abc import Callable
from fractions import Fraction

from kagezou.contexts import open_context
from kagezou.errors import (
    DiskFullProblem,
    GraphicsProblem,
    InputProblem,
    OutputProblem,
    Problem,
    ProjectProblem,
    Stopped,
    UsageProblem,
)
from kagezou.interface.cut import Cut
from kagezou.interface.exporting import Exported, ExportedFile, HandingOnFailed
from kagezou.interface.opening import DrawingChoice, NewWish, edit_cut, make_cut, open_cut
from kagezou.interface.pictures import RenderedFrame
from kagezou.interface.values import AnyPath, PropertyKey
from kagezou.interface.wishes import AfterEffects, Frames, SceneFor, Video
from kagezou.io.clips.style_files import styles_there
from kagezou.locations import own_style_folder

__all__ = [
    "AfterEffects",
    "Cut",
    "DiskFullProblem",
    "Exported",
    "ExportedFile",
    "Frames",
    "GraphicsProblem",
    "HandingOnFailed",
    "InputProblem",
    "OutputProblem",
    "Problem",
    "ProjectProblem",
    "PropertyKey",
    "RenderedFrame",
    "SceneFor",
    "Stopped",
    "UsageProblem",
    "Video",
    "edit",
    "new",
    "open",
    "styles",
]


def open(path: AnyPath) -> Cut:  # noqa: A001 - said with the name of the module before it
    """Return the cut of a project file; drawings are not opened yet.

    Raises
    ------
    ProjectProblem
        The file is missing, damaged or from a newer version.
    """
    return open_cut(path, open_context)


def new(
    drawings: DrawingChoice,
    *,
    background: AnyPath | None = None,
    timesheet: AnyPath | None = None,
    size: tuple[int, int] | None = None,
    fps: str | float | Fraction | None = None,
    template: AnyPath | Cut | None = None,
) -> Cut:
    """Return a cut of drawings, with a light that shows a good shadow at once; its feet are found by `Cut.with_feet`.

    Parameters
    ----------
    drawings
        Names of characters with a folder, a pattern such as ``walk_#.png``, a picture or a PSD file each, from the
        lowest to the topmost, ``"Hero=arm"`` for one more cel of Hero; or one file that holds a cut: PSD, OCA or a
        timesheet with its columns' drawings beside it.
    background
        A picture under everything, or a folder or a pattern of pictures.
    timesheet
        A file that says when which drawing is exposed.
    size, fps
        Of the canvas: px, and frames a second; None for those of an OCA file, the template, or the pictures and 24.
    template
        A cut or a project file whose canvas, rate, light, looks, ground and set are taken.

    Raises
    ------
    UsageProblem, InputProblem, ProjectProblem
        A file cannot be found or read, or a name is none.
    """
    return make_cut(drawings, NewWish(background, timesheet, size, fps, template), open_context)


def edit(path: AnyPath, change: Callable[[Cut], Cut]) -> Cut:
    """Open a project, change it by a function and save it, while no other script or command line can change it.

    The function returns another cut and does not save it; where it returns the same, nothing is written.

    Raises
    ------
    ProjectProblem, OutputProblem, DiskFullProblem
        It cannot be read or written, or somebody else holds it for half a minute.
    """
    return edit_cut(path, change, open_context)


def styles() -> tuple[str, ...]:
    """Return the English names of the styles there are: the program's, the studio's and the user's own.

    A folder or file that cannot be read is a warning.
    """
    found, problems = styles_there(own_style_folder())
    for problem in problems:
        warnings.warn(str(problem), stacklevel=2)
    return tuple(each.style.name.en for each in found)
