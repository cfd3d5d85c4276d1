"""Kagezou makes cast-shadow layers for 2D animation from transparent character drawings.

``import kagezou`` is the program for scripts; ``docs/en/python.md`` describes it. The rooms of the program and what
each may use are listed in ``app/README.md``. Nothing is imported before it is asked for, so that neither the command
line nor a script that only looks pays for what it does not use.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from kagezou.version import __version__

if TYPE_CHECKING:
    from kagezou.public import (
        AfterEffects,
        Cut,
        DiskFullProblem,
        Exported,
        ExportedFile,
        Frames,
        GraphicsProblem,
        HandingOnFailed,
        InputProblem,
        OutputProblem,
        Problem,
        ProjectProblem,
        PropertyKey,
        RenderedFrame,
        SceneFor,
        Stopped,
        UsageProblem,
        Video,
        edit,
        new,
        open,  # noqa: A004 - said with the name of the module before it
        styles,
    )

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
    "__version__",
    "edit",
    "new",
    "open",
    "styles",
]

if not TYPE_CHECKING:  # Who checks types is told of a name that is not there.

    def __getattr__(name: str) -> object:
        if name in __all__:
            return getattr(import_module("kagezou.public"), name)
        raise AttributeError(f"module 'kagezou' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
