"""From files to a document: drawings, timesheets, PSD files and sets become characters, exposures and set pieces.

It may use the scene, the document and the files' room.
It must never know what somebody is doing with a document (its history, its frame), nor Qt, OpenGL or a terminal.
"""
