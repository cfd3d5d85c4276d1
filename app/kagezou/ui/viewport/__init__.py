"""The picture: the one widget with an OpenGL context, the handles painted over it and the hand that drags them.

It may use the renderer, the tools, the scene and the bridge.
It must never know the panels or how a handle turns pointers into documents.
"""
