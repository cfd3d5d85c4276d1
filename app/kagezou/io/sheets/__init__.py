"""Timesheets: XDTS, TDTS and STS, as columns of numbered drawings.

It may use the standard library and the room of files.
It must never know layers, drawings or their files.
"""
