"""USD stages being opened, with nothing that lies outside of their folder."""

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from kagezou.io.files.faults import input_problem
from kagezou.io.sets.bounded_bytes import check_inside, state_of
from kagezou.io.sets.triangles import listed
from kagezou.message import Message

_MAX_LAYERS: Final = 10_000


@dataclass(frozen=True, slots=True)
class OpenStage:
    """A stage, its file, the time of its first frame, and what of its layers is not there."""

    path: Path
    stage: Any
    time: Any
    notes: tuple[Message, ...]


def pxr(name: str) -> Any:
    """Return a module of USD's package, which has no types."""
    return import_module(f"pxr.{name}")


def open_stage(path: Path) -> OpenStage:
    """Open a stage; InputProblem where the file is broken or made of what lies outside of its folder."""
    state_of(path)
    stages = pxr("Usd").Stage
    try:
        missing = _missing_layers(path)
        stage = stages.Open(str(path), stages.LoadAll)
    except pxr("Tf").ErrorException as error:
        raise input_problem(path, Message("it cannot be read as USD: the file is damaged")) from error
    if stage is None:
        raise input_problem(path, Message("it cannot be read as USD: the file is damaged"))
    codes = pxr("Usd").TimeCode
    time = codes(stage.GetStartTimeCode()) if stage.HasAuthoredTimeCodeRange() else codes.EarliestTime()
    notes = (Message("it refers to {names}, which cannot be read", names=listed(missing)),) if missing else ()
    return OpenStage(path, stage, time, notes)


def numbers_of(path: Path, attribute: Any, time: Any) -> NDArray[Any]:
    """Return a list of numbers or of points that an attribute holds, (N,) or (N, 3); InputProblem for anything else.

    Whoever writes a file may give any attribute any type.
    """
    found = np.asarray(attribute.Get(time) or ())
    if found.ndim not in (1, 2) or found.dtype.kind not in "iuf" or found.shape[1:] not in ((), (3,)):
        raise input_problem(path, Message("it cannot be read as USD: the file is damaged"))
    return found


def _missing_layers(path: Path) -> list[str]:
    """Return which layers a stage is made of cannot be read, having seen that none lies outside of its folder."""
    waiting: list[tuple[Path, str]] = [(path, "")]
    seen, missing = {path}, list[str]()
    while waiting:
        place, said = waiting.pop()
        layer = _layer(place)
        if layer is None:
            missing.append(said)
            continue
        # A package holds its own layers.
        is_package = place.suffix.lower() == ".usdz"
        for name in () if is_package else layer.GetCompositionAssetDependencies():
            check_inside(place, name)
            if (other := place.parent / name) not in seen:
                seen.add(other)
                waiting.append((other, name))
        if len(seen) > _MAX_LAYERS:
            raise input_problem(path, Message("it is made of more than {most} layers", most=_MAX_LAYERS))
    # The file itself is opened anyway, and says so then.
    return [name for name in missing if name]


def _layer(place: Path) -> Any:
    try:
        return pxr("Sdf").Layer.FindOrOpen(str(place))
    except pxr("Tf").ErrorException:
        return None
