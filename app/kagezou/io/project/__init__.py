"""The project file: read, written, led over from older versions, and kept for recovery.

It may use the document and the room of files.
It must never know pixels, Qt or what is done with the document afterwards.
"""
