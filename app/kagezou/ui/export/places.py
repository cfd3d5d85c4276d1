"""Where an export goes: beside its project, or where that project's exports went the last time."""

import json
from pathlib import Path
from typing import Final

from PySide6.QtCore import QStandardPaths

from kagezou.export.choices import Place
from kagezou.ui.system.settings import Settings

_REMEMBERED: Final = "export_folders"
MOST: Final = 64
"""So many projects are remembered, the latest."""


def place_for(settings: Settings, project: Path | None, name: str) -> Place:
    """Return where an export is proposed to go.

    Parameters
    ----------
    project
        The project's file; None for one that is not saved, whose exports go to the user's documents.
    name
        What the cut is called.
    """
    usual = _usual_folder(project, name)
    kept = _remembered(settings).get(str(project), "")
    # The disk of the last time may not be there today.
    folder = Path(kept) if kept and Path(kept).parent.is_dir() else usual
    return Place(folder, project, name)


def remember_place(settings: Settings, place: Place) -> None:
    """Keep where the exports of a saved project go; the usual folder moves with the project."""
    if place.project is None:
        return
    known = _remembered(settings)
    known.pop(str(place.project), None)
    if place.folder != _usual_folder(place.project, place.name):
        known[str(place.project)] = str(place.folder)
    latest = dict(list(known.items())[-MOST:])
    settings.set_word(_REMEMBERED, json.dumps(latest, ensure_ascii=False))


def _usual_folder(project: Path | None, name: str) -> Path:
    if project is not None:
        return project.parent / f"{name}_export"
    documents = QStandardPaths.writableLocation(QStandardPaths.StandardLocation.DocumentsLocation)
    return (Path(documents) if documents else Path.home()) / f"{name}_export"


def _remembered(settings: Settings) -> dict[str, str]:
    """Return folder by project; what cannot be read is forgotten."""
    try:
        found = json.loads(settings.word(_REMEMBERED, "{}"))
    except ValueError:
        return {}
    return {str(key): str(value) for key, value in found.items()} if isinstance(found, dict) else {}
