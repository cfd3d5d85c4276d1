"""Parts of the program that are installed apart from it, and how they are added."""

from dataclasses import dataclass
from importlib.util import find_spec
from typing import Final

from kagezou.message import Message


@dataclass(frozen=True, slots=True)
class Extra:
    """One such part.

    Parameters
    ----------
    name
        What installers know it by.
    module
        By whose presence it is told.
    purpose
        What cannot be done without it.
    """

    name: str
    module: str
    purpose: Message

    @property
    def is_there(self) -> bool:
        """Whether it is installed; nothing of it is imported."""
        return find_spec(self.module) is not None

    @property
    def how(self) -> Message:
        """How it is added, as a terminal says it; the window leads to a dialog instead."""
        return Message("pip install 'kagezou[{extra}]'", extra=self.name)


VIDEO: Final = Extra("video", "av", Message("writing videos"))
USD: Final = Extra("usd", "pxr", Message("reading sets in USD files"))
DRACO: Final = Extra("draco", "DracoPy", Message("reading sets that are compressed with Draco"))
PSD: Final = Extra("psd", "scipy", Message("drawing gradients, strokes and curves of Photoshop layers"))
EXTRAS: Final = (VIDEO, USD, DRACO, PSD)

HOW: Final = VIDEO.how.text
"""The text of every `Extra.how`."""
