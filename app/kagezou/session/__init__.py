"""What one person is doing with a document: the document now, its history, the frame, the selection.

It may use the document, the scene and the files' room.
It must never know Qt, OpenGL or a mouse; whoever wants to show it listens to its one callback.
"""
