"""What a hand can do on the picture: handles, the drags that belong to them, and how the canvas is seen.

It may use session, scene, document, animation and geometry; all of it is values, pure functions and generators.
It must never know Qt, OpenGL, files or pixels of an image, and it never changes a document in place.

What the window uses
--------------------
``view``: ``View(zoom, origin_view_px)``, ``View.fitted(canvas_size, view_size, margin_px)``, ``.zoomed_at``,
``.panned``, ``.view_from_canvas``, ``.canvas_from_view``. View px are logical px from the viewport's top left.

``pointer``: ``Modifiers(constrain, fine, symmetric, snap)``, ``Modifiers.of_keys(shift=, alt=, ctrl=)``,
``Pointer(view_px, canvas_px, modifiers)``, ``Pointer.seen_at(view, view_px, modifiers)``.

``handle``: ``Handle``, ``Guide``, ``HandleSet`` (``.find(id)``), ``Shape``, ``Cursor``, ``GuideKind``,
``hit(handles, view, view_px, radius, view_size)``, ``place_in_view(handle, view, view_size)`` for drawing,
``clamped``, ``OffView``, ``HIT_RADIUS_PX``, ``PEN_HIT_RADIUS_PX``.

``handles``: ``handles_of(document, frame, layer_id, view, piece_id)``, ``matching_handles_of(document, frame, view)``,
``drag_of(handle, document, frame, view)``, ``nudge(handle, document, frame, dx, dy, view)``.

``grounding``: ``add_grounding(document, layer_id, frame, canvas_px)``, and
``remove_grounding(document, layer_id, frame, index)`` with ``handle.index``.

``placing``: ``add_placed(document, frame, layer_id, kind, name)``.

``corner``: ``drawing(document, lay)`` is a drag that draws a line; what it lays is ``ground_line(document, frame)`` or
``wall_line(document, frame, layer_id, name)``; ``is_on_ground(document, frame, canvas_px)``.

``set_outlines``: ``outlines_of(document, frame)``, ``piece_at(outlines, view, view_px, reach)``.

``readout``: ``readout(handle, before, after, frame, language)``.

A drag, from press to release or Escape::

    drag = drag_of(handle, start, frame, view)
    drag.send(press)                    # the start document
    document = drag.send(pointer)       # for each move
    drag.close()                        # at release, and for Escape, which shows the start document again
"""
