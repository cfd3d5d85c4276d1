"""Passes over the flat and round faces of a set, joined into its shadows.

It may use `render.passes`, `render.meshes`, `render.gpu` and `render.prepare`.
It must never know the renderer or the document.
"""
