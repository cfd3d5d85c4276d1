"""What one person is doing with a document: the document now, its history, the frame, the selection.

It may use the document and the scene.
It must never know Qt, OpenGL, files or a mouse; whoever wants to show it listens to its one callback.
"""
