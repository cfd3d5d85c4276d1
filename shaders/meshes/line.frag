#version 330 core
// A line of a mesh, left out where a surface is seen that hides it.

#include "meshes/surface.glsl"

uniform float u_half_px;               // half the line's width

in vec2 v_across_px;
in float v_nearness;

out float o_coverage;

const float BEHIND_PX = 0.75;          // a line that lies no deeper in a surface belongs to it

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    vec3 start = ray_start(pixel);
    vec3 along = ray_along(start);
    vec3 place = start + along * (u_eye.w == 0.0 ? v_nearness : 1.0 / v_nearness - 1.0);
    uvec4 record = texelFetch(u_pixels, ivec2(gl_FragCoord.xy), 0);
    int held = 0;
    bool seen = false;
    for (int part = 0; part < PARTS; ++part) {
        int triangle = part_triangle(record, part);
        vec4 plane = plane_of(max(triangle, 1));
        float behind = (dot(plane.xyz, place) + plane.w) * sign(dot(plane.xyz, along));
        seen = seen || (triangle > 0 && behind < BEHIND_PX);
        held |= part_mask(record, part);
    }
    float away = length(v_across_px);
    o_coverage = seen || held != WHOLE ? clamp(u_half_px + 0.5 - away, 0.0, 1.0) : 0.0;
}
