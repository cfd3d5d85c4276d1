"""Kagezou makes cast-shadow layers for 2D animation from transparent character drawings.

The rooms of the program and what each may use are listed in ``app/README.md``.
Nothing is imported here, so that the command line never pays for the window.
"""

from kagezou.version import __version__

__all__ = ["__version__"]
