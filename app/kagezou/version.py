"""The version of the program, which every room may say."""

__version__ = "0.1.0"
