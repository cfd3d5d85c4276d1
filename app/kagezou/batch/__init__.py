"""Many cuts at once: which folders and files are cuts, one after the other made into project and output, and a report.

It may use export, importing, and every room below them.
It must never know a terminal, the words of a command line, nor Qt.
"""
