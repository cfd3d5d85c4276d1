"""The only room that knows OpenGL: from a scene to pixels, the same ones in the window and on a farm.

It may use the scene, geometry and the cels that the files' room decodes; it draws into targets of its own.
It must never know the document, the session, Qt, or who made the context that is current.
"""
