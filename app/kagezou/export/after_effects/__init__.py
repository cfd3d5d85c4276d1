"""The hand-off to After Effects: footage in folders and one script that builds the composition.

It may use the frames that the export room writes, and the document.
It must never know what a person did in After Effects: the script finds that out where it runs.
"""
