"""Choices of an export as text: what settings and presets remember."""

import json
from dataclasses import asdict, fields, replace

from kagezou.export.after_effects.mattes import MATTES
from kagezou.export.choices import ExportChoices
from kagezou.export.exporters.table import sound


def dumps_choices(choices: ExportChoices) -> str:
    """Return choices as text to remember them by."""
    return json.dumps(asdict(choices), ensure_ascii=False)


def loads_choices(text: str) -> ExportChoices:
    """Return remembered choices; whatever is not understood has its usual value."""
    try:
        return choices_of(json.loads(text))
    except ValueError:
        return ExportChoices()


def choices_of(found: object) -> ExportChoices:
    """Return the choices that JSON was made of; whatever is not understood has its usual value."""
    usual = ExportChoices()
    given = found if isinstance(found, dict) else {}
    plain = {
        field.name: given[field.name]
        for field in fields(ExportChoices)
        if type(given.get(field.name)) is type(getattr(usual, field.name))
    }
    mattes = given.get("mattes")
    chosen = tuple(each for each in MATTES if isinstance(mattes, list) and each in mattes)
    return sound(replace(usual, **plain, mattes=chosen))
