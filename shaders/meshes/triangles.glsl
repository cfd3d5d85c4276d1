// The triangles of the meshes, world px around one origin near them.

#ifndef TRIANGLES
#define TRIANGLES
uniform sampler2D u_triangles;         // four texels each: three corners, then the plane; flags beside the first corner

const int ROW = 1024;                  // triangles in a row of u_triangles

vec4 triangle_part(int triangle, int part) {
    int index = triangle - 1;
    return texelFetch(u_triangles, ivec2((index & (ROW - 1)) * 4 + part, index / ROW), 0);
}
#endif
