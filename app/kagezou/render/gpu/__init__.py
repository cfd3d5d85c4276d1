"""Objects of the graphics card: context, programs, targets, textures, and what is kept on it between frames.

It may use OpenGL and the numbers that `render.prepare` makes.
It must never know a pass, or in which order passes are drawn.
"""
