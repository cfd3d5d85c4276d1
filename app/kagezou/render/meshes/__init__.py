"""Passes over meshes: what of them is seen, what of them is lit, and how they are shown.

It may use `render.gpu` and `render.prepare`.
It must never know the passes beside it, nor the document.
"""
