#version 330 core
// Between which lengths of their view rays the meshes are seen in the pixels of each tile; the first is the greater
// where none is.

#include "meshes/surface.glsl"

uniform int u_tile_px;

out vec4 o_range;                      // ... and whether nothing else is seen

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * u_tile_px;
    ivec2 size = textureSize(u_pixels, 0);
    vec2 range = vec2(1e30, -1e30);
    bool filled = true;
    for (int index = 0; index < u_tile_px * u_tile_px; ++index) {
        ivec2 at = first + ivec2(index % u_tile_px, index / u_tile_px);
        bool inside = all(lessThan(at, size));
        uvec4 record = inside ? texelFetch(u_pixels, at, 0) : uvec4(0u);
        int mask = 0;
        for (int part = 0; part < PARTS; ++part) {
            mask |= part_mask(record, part);
            int triangle = part_triangle(record, part);
            // The corners of the pixel hold all of what lies between.
            for (int corner = 0; triangle > 0 && corner < 4; ++corner) {
                vec2 offset = vec2(float(corner & 1), float(corner >> 1));
                vec3 start = ray_start(vec2(at) + offset - u_origin_px);
                float reach = reach_of(plane_of(triangle), start, ray_along(start));
                range = vec2(min(range.x, reach), max(range.y, reach));
            }
        }
        filled = filled && (mask == WHOLE || !inside);
    }
    o_range = vec4(range, filled ? 1.0 : 0.0, 0.0);
}
