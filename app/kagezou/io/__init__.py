"""Files: pictures in and out, numbered sequences, and whatever else is kept on a disk.

It may use numpy, OpenImageIO (through `oiio_guard` alone), kornia-rs (through `fast_png` alone), isal, the geometry's
boxes and, for the project file, the document. It must never know Qt, OpenGL, the scene, the session or how a shadow is
drawn.
"""
