"""After an export: a manifest of what was made, and the studio's own programs that it is handed to.

It may use the other rooms of export, and starts programs. It must never know who asked for the export, nor draw.
"""
