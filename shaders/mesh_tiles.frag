#version 330 core
// Between which lengths of their view rays the meshes are seen in the pixels of each tile; the first is the greater
// where none is.

#include "mesh_surface.glsl"

uniform int u_tile_px;

out vec4 o_range;                      // ... and whether nothing else is seen

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * u_tile_px;
    ivec2 size = textureSize(u_pixels, 0);
    vec2 range = vec2(1e30, -1e30);
    bool filled = true;
    for (int index = 0; index < u_tile_px * u_tile_px; ++index) {
        ivec2 at = first + ivec2(index % u_tile_px, index / u_tile_px);
        uint record = all(lessThan(at, size)) ? texelFetch(u_pixels, at, 0).r : 0u;
        bool several = (record & SEVERAL) != 0u;
        filled = filled && (record != 0u || !all(lessThan(at, size)));
        int count = record == 0u ? 0 : several ? u_side * u_side : 4;
        for (int part = 0; part < count; ++part) {
            int triangle = several ? sample_at(at, part) : int(record);
            // The corners of the pixel hold all of what lies between.
            vec2 offset = several ? sample_offset(part, u_side) : 2.0 * sample_offset(part, 2);
            filled = filled && triangle > 0;
            if (triangle > 0) {
                vec3 start = ray_start(vec2(at) + 0.5 - u_origin_px + offset);
                float reach = reach_of(plane_of(triangle), start, ray_along(start));
                range = vec2(min(range.x, reach), max(range.y, reach));
            }
        }
    }
    o_range = vec4(range, filled ? 1.0 : 0.0, 0.0);
}
