"""What a bundle starts: the front door of the program."""

import sys

from kagezou.__main__ import program, window

# Of the two programs on Windows one has no console.
sys.exit(window() if sys.executable.lower().endswith("kagezou-window.exe") else program())
