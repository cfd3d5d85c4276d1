"""Planes, rays and projections of the drawing's world, and where a drawing's shadow falls.

It may use numpy and nothing of the program above it; all of it is pure functions over frozen values in float64.
It must never know documents, frames, pixels of an image or OpenGL.

Space: canvas pixels with the origin top left, x right, **y down**, z toward the viewer; the drawing lies in z = 0.
Matrices are named ``target_from_source`` and act on homogeneous column vectors.
"""
