"""Bodies of a set, what of their faces is seen and lit, and how they are laid flat.

It may use numpy and the geometry beside this folder; all of it is pure functions over frozen values in float64.
It must never know documents, frames, meshes of files or OpenGL: the shadow of one card is the other half of geometry.
"""
