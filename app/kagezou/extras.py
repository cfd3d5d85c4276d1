"""Parts of the program that are installed apart from it, and how they are added."""

from dataclasses import dataclass
from importlib.util import find_spec
from typing import Final

from kagezou.message import Message
from kagezou.own_process import is_bundle

IN_BUNDLE: Final = Message("this bundle has it not; an installation in a Python can have it")


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
    packages
        What is installed for it: packages of the Python index by their own names, as nobody keeps Kagezou's there.
    """

    name: str
    module: str
    purpose: Message
    packages: tuple[str, ...]

    @property
    def is_there(self) -> bool:
        """Whether it is installed; nothing of it is imported."""
        return find_spec(self.module) is not None

    @property
    def how(self) -> Message:
        """How it is added, as a terminal says it; the window leads to a dialog instead."""
        if is_bundle():
            return IN_BUNDLE
        return Message("pip install {packages}", packages=install_words(self.packages))


VIDEO: Final = Extra("video", "av", Message("writing videos"), ("av>=18,<21",))
USD: Final = Extra("usd", "pxr", Message("reading sets in USD files"), ("usd-core>=26.5",))
DRACO: Final = Extra("draco", "DracoPy", Message("reading sets that are compressed with Draco"), ("DracoPy>=2.2,<3",))
PSD: Final = Extra(
    "psd",
    "scipy",
    Message("drawing gradients, strokes and curves of Photoshop layers"),
    ("aggdraw>=1.4.1,<2", "scipy>=1.17,<2"),
)
EXTRAS: Final = (VIDEO, USD, DRACO, PSD)

HOW: Final = frozenset({IN_BUNDLE.text, "pip install {packages}"})
"""The texts of every `Extra.how`."""


def install_words(packages: tuple[str, ...]) -> str:
    """Return packages as words for pip in a terminal, quoted as shells want them."""
    return " ".join(f"'{each}'" for each in packages)
