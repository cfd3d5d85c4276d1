"""How fast this machine is: milliseconds from a changed document to finished pixels, and frames a second of an export.

It may use every room below the command line.
It must never know how its figures are shown.
"""
