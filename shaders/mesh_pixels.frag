#version 330 core
// Gathers the samples of each pixel: one triangle where all of them lie in its plane, else a mark that there are more.

#include "mesh_surface.glsl"

uniform float u_flat_px;               // how far from the plane samples may lie

out uint o_pixel;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    int count = u_side * u_side;
    int low = 0x7fffffff, high = 0;
    for (int index = 0; index < count; ++index) {
        int triangle = sample_at(at, index);
        low = min(low, triangle);
        high = max(high, triangle);
    }
    int middle = sample_at(at, count / 2 + u_side / 2);
    middle = middle == 0 ? high : middle;
    bool several = low == 0 && high > 0;
    if (low > 0 && low != high) {
        vec4 plane = plane_of(middle);
        for (int index = 0; index < count; ++index) {
            vec3 place = met(plane_of(sample_at(at, index)), pixel + sample_offset(index, u_side));
            several = several || abs(dot(plane.xyz, place) + plane.w) > u_flat_px;
        }
    }
    o_pixel = uint(middle) | (several ? SEVERAL : 0u);
}
