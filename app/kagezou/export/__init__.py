"""A document as files of frames: what is to be drawn, by which names it is kept, and the pipeline that makes it.

It may use render, the scene, the files' room and the document.
It must never know the session, Qt, a terminal, or who asked.
"""
