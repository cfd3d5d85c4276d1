"""Files of sets: glTF, OBJ, PLY, STL and USD, as triangles and cameras.

It may use earcut, DracoPy, OpenUSD, numpy and the geometry's meshes; a decoder gets bytes in memory and no way to
other files.
It must never know documents or where a set is put.
"""
