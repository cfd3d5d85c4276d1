"""Numbers for the passes: tiles, bands, charts and uniforms, made of a scene and of what a matte holds.

It may use numpy, the geometry and the scene; every function can be tested without a context.
It must never know OpenGL.
"""
