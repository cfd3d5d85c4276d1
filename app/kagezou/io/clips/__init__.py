"""Small texts that people exchange: the clipboard's keys and values, styles, sets of shortcuts.

It may use the document and the project file's fields.
It must never know pictures, meshes, Qt or the clipboard itself.
"""
