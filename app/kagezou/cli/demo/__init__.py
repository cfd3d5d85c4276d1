"""The demo's own drawings: a child with a balloon, drawn by the program itself, and the meadow it walks over.

It may use numpy, the document and the files' room.
It must never know OpenGL, a terminal, or what the drawings will be used for.
"""
