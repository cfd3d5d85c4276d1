"""The panels beside the picture: the list of layers and the inspector of properties.

They may use the bridge, the theme, the document and its edits.
They must never know the viewport, OpenGL or files: what they change goes through the session.
"""
