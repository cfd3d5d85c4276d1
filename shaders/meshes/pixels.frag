#version 330 core
// Gathers the samples of each pixel: those that lie near one plane become one part.

#include "meshes/surface.glsl"

uniform usampler2D u_samples;          // the triangles seen in the samples, counted from 1
uniform int u_side;                    // samples of a pixel, each way
uniform float u_flat_px;               // how far from a part's plane its samples may lie

out uvec4 o_pixel;

int sample_at(ivec2 pixel, int index) {
    int place = sample_place(index);
    ivec2 at = ivec2(place % FINE, place / FINE) * u_side / FINE;
    return int(texelFetch(u_samples, pixel * u_side + at, 0).r);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    int triangles[PARTS] = int[](0, 0, 0);
    int masks[PARTS] = int[](0, 0, 0);
    vec4 planes[PARTS];
    int seen = 0;
    int low = 0x7fffffff, high = 0;
    for (int index = 0; index < FINE * FINE; ++index) {
        int triangle = sample_at(at, index);
        low = min(low, triangle);
        high = max(high, triangle);
    }
    // Mostly there is but one.
    int count = low == high ? 0 : FINE * FINE;
    triangles[0] = low == high ? high : 0;
    masks[0] = triangles[0] > 0 ? WHOLE : 0;
    for (int index = 0; index < count; ++index) {
        int triangle = sample_at(at, index);
        if (triangle > 0) {
            vec4 plane = plane_of(triangle);
            vec3 place = met(plane, pixel + sample_offset(index));
            int part = PARTS;
            for (int known = PARTS - 1; known >= 0; --known) {
                bool lies = known < seen
                         && (triangles[known] == triangle
                             || abs(dot(planes[known].xyz, place) + planes[known].w) <= u_flat_px);
                part = lies ? known : part;
            }
            if (part == PARTS && seen < PARTS) {
                part = seen;
                triangles[part] = triangle;
                planes[part] = plane;
                seen += 1;
            }
            // Of more planes than there is room for the last counts for the rest; its first sample is its own.
            part = min(part, PARTS - 1);
            masks[part] |= 1 << index;
        }
    }
    o_pixel = uvec4(0u);
    for (int part = 0; part < PARTS; ++part) {
        o_pixel[part] = uint(triangles[part]) | uint(masks[part] & 0xFF) << 24;
        o_pixel.w |= uint(masks[part] >> 8) << uint(8 * part);
    }
}
