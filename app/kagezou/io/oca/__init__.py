"""Open Cel Animation: documents of layers, whose frames are picture files.

It may use the standard library and the rooms of files and timesheets.
It must never know what is made of layers, nor open their pictures.
"""
