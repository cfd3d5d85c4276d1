#version 330 core
// The shadow on the meshes: every part of a pixel is met with the triangle seen there, and from there with the card and
// with what takes the light. Switches:
//   TRANSLUCENT   see common/card_in_space.glsl
//   FULL          the card casts fully everywhere here
//   OWN_SHADOW    writes what the set takes from the light instead; those meshes that cast grow dark when turned away
//   MESHES        the meshes take the light, too

#include "common/edge.glsl"
#include "sets/occlusion_cones.glsl"
#include "meshes/surface.glsl"
#if !defined(OWN_SHADOW) && !defined(FULL)
#include "common/card_in_space.glsl"
#endif
#ifdef MESHES
#include "meshes/light.glsl"
#endif

uniform vec4 u_ground;                 // hides what lies below it; positive on the side of the eye
uniform vec4 u_light;                  // homogeneous
uniform vec2 u_grazing_sine;

out float o_coverage;

const int RECEIVES = 1, CASTS = 2;

// state: what is known of the meshes' light in the whole pixel.
float part_shade(int triangle, vec4 plane, vec2 pixel, vec2 cell, int state) {
    vec3 here = met(plane, pixel);
    mat2x3 cell_world = pixel_on(plane, pixel);
    cell_world = mat2x3(cell_world[0] * cell.x, cell_world[1] * cell.y);
    vec4 place = vec4(here, 1.0);
    vec3 toward = u_light.xyz - u_light.w * here;
    vec3 to_eye = u_eye.xyz - u_eye.w * here;
    float sine = dot(plane.xyz, toward) * sign(dot(plane.xyz, to_eye)) / length(toward);
    float strength = smoothstep(u_grazing_sine.x, u_grazing_sine.y, sine);
    int flags = int(triangle_part(triangle, 0).w);
    vec2 left = seen_and_lit(place, cell_world);
    left.x *= dot(u_ground, place) > -TIE_PX ? 1.0 : 0.0;
#ifdef OWN_SHADOW
    bool casts = (flags & CASTS) != 0;
    float wanted = left.x * strength;
#else
    float wanted = (flags & RECEIVES) == 0 ? 0.0 : left.x * left.y * strength;
#ifndef FULL
    wanted *= cast_coverage(place, cell_world);
#endif
#endif
    float lit = 1.0;
#ifdef MESHES
    lit = state == LIT ? 1.0 : 0.0;
    if (wanted > 0.0 && state == EDGE) {
        lit = is_dark(here, plane.xyz) ? 0.0 : 1.0;
    }
#endif
#ifdef OWN_SHADOW
    return casts ? left.x * (1.0 - strength * left.y * lit) : wanted * (1.0 - left.y * lit);
#else
    return wanted * lit;
#endif
}

// Into how many cells each way a pixel is split: about one a texel of the drawing.
ivec2 cells_of(vec4 plane, vec2 pixel) {
#if defined(OWN_SHADOW) || defined(FULL)
    return ivec2(1);
#else
    mat2x3 step_world = pixel_on(plane, pixel);
    vec3 h = projected(vec4(met(plane, pixel), 1.0));
    vec2 texel = h.xy / h.z;
    vec3 step_x = projected(vec4(step_world[0], 0.0)), step_y = projected(vec4(step_world[1], 0.0));
    vec2 stretch = vec2(length(step_x.xy - texel * step_x.z), length(step_y.xy - texel * step_y.z)) / abs(h.z);
    return ivec2(clamp(ceil(stretch * 1.25), vec2(1.0), vec2(float(FINE))));
#endif
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uvec4 record = texelFetch(u_pixels, ivec2(gl_FragCoord.xy), 0);
    int first = part_triangle(record, 0);
    vec4 plane = plane_of(max(first, 1));
    bool alone = part_mask(record, 0) == WHOLE;
    float height = dot(u_ground, vec4(met(plane, pixel), 1.0)) + TIE_PX;
    vec2 slope = abs(u_ground.xyz * pixel_on(plane, pixel));
    // Where the ground comes through, samples add up with those of the ground (meshes/past.frag).
    bool finely = abs(height) < 0.5 * (slope.x + slope.y);
    int state = 0;
#ifdef MESHES
    state = alone ? light_state(met(plane, pixel), plane.xyz, pixel_on(plane, pixel)) : EDGE;
    finely = finely || (alone && state == EDGE);
#endif
    ivec2 cells = finely ? ivec2(FINE) : alone ? cells_of(plane, pixel) : ivec2(PARTS, 1);
    int count = first == 0 ? 0 : cells.x * cells.y;
    bool in_parts = !finely && !alone;
    vec2 cell = in_parts ? vec2(1.0) : 1.0 / vec2(cells);
    float sum = 0.0;
    for (int index = 0; index < count; ++index) {
        int part = in_parts ? index : alone ? 0 : part_with(record, 1 << index);
        int mask = part < PARTS ? part_mask(record, part) : 0;
        if (mask != 0) {
            int triangle = part_triangle(record, part);
            vec4 own = alone ? plane : plane_of(triangle);
            vec2 offset = (vec2(float(index % cells.x), float(index / cells.x)) + 0.5) * cell - 0.5;
            offset = in_parts ? sample_offset(first_of(mask)) : finely ? sample_offset(index) : offset;
            float weight = in_parts ? count_of(mask) / 16.0 : cell.x * cell.y;
            sum += part_shade(triangle, own, pixel + offset, cell, state) * weight;
        }
    }
    o_coverage = sum;
}
