"""What a hand can do on the picture: handles, the drags that belong to them, and how the canvas is seen.

It may use session, scene, document, animation and geometry; all of it is values, pure functions and generators.
It must never know Qt, OpenGL, files or pixels of an image, and it never changes a document in place.

`handles` knows which there are and which drag belongs to each, `handle` where one lies and what is hit; `curves` and
`timeline` hold the drags of keys, drawings and ease handles. A place on screen is in logical px from the viewport's
top left (``_view_px``).

A drag, from press to release or Escape::

    drag = drag_of(handle, start, frame, view)
    drag.send(press)                    # the start document
    document = drag.send(pointer)       # for each move
    drag.close()                        # at release, and for Escape, which shows the start document again
"""
