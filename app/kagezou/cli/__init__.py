"""The command line: every verb of the program for people at a terminal, scripts and farms.

It may use every room below it, and the entry_points that `__main__` hands it: an OpenGL context, and the window.
It must never know Qt, nor import numpy, OpenGL or OpenImageIO before a verb needs them.
"""
