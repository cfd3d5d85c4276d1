"""One file a pass: the shadow on flat receivers, its filter, and the finished picture.

It may use `render.meshes`, `render.gpu` and `render.prepare`; every pass states its whole OpenGL state.
It must never know the renderer, which alone knows the order.
"""
