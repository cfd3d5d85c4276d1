"""Pictures in and out: cels and their caches, numbered sequences, layered pictures, video.

It may use numpy, OpenImageIO (through `oiio_guard` alone), kornia-rs (through `fast_png` alone), the rooms of PSD and
pixels, and documents' cels. It must never know a scene, OpenGL or how a shadow is drawn.
"""
