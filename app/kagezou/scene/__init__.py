"""One frame of a document as plain numbers, ready to be drawn.

It may use the document, animation and geometry.
It must never know OpenGL, pixels or files' contents: the same document and frame give the same scene, everywhere.
"""
