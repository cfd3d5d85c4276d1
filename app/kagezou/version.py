"""The version of the program, which every room may say."""

from importlib.metadata import version

__version__ = version("kagezou")
