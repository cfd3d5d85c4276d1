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
#else
const int LIT = 0, EDGE = 2;           // nothing takes the light
#endif

uniform vec4 u_ground;                 // hides what lies below it; positive on the side of the eye
uniform vec4 u_light;                  // homogeneous
uniform vec2 u_grazing_sine;

out float o_coverage;

const int RECEIVES = 1, CASTS = 2;

// How strong a shadow is: where the light stands low over a surface there is none.
float strength_at(vec3 normal, vec3 here) {
    vec3 toward = u_light.xyz - u_light.w * here;
    vec3 to_eye = u_eye.xyz - u_eye.w * here;
    float sine = dot(normal, toward) * sign(dot(normal, to_eye)) / length(toward);
    return smoothstep(u_grazing_sine.x, u_grazing_sine.y, sine);
}

// state: what is known of the meshes' light in the whole pixel.
float part_shade(int triangle, vec4 plane, vec2 pixel, vec2 cell, int state) {
    vec3 here = met(plane, pixel);
    mat2x3 cell_world = pixel_on(plane, pixel);
    cell_world = mat2x3(cell_world[0] * cell.x, cell_world[1] * cell.y);
    vec4 place = vec4(here, 1.0);
    float strength = strength_at(plane.xyz, here);
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
    bool at_edge = wanted > 0.0 && state == EDGE;
    lit = is_dark(here, plane.xyz, at_edge) || state == DARK ? 0.0 : 1.0;
#endif
#ifdef OWN_SHADOW
    return casts ? left.x * (1.0 - strength * left.y * lit) : wanted * (1.0 - left.y * lit);
#else
    return wanted * lit;
#endif
}

#if !defined(OWN_SHADOW) && !defined(FULL)
// On the matte, as places_on has it: how far one px goes in x, in y, and the place at the pixel.
mat3 on_matte(mat3x4 places) {
    return mat3(projected(places[0]), projected(places[1]), projected(places[2]));
}

// Into how many cells each way a pixel is split: about one a texel of the drawing.
ivec2 cells_of(mat3 matte) {
    vec2 texel = matte[2].xy / matte[2].z;
    vec2 stretch = vec2(length(matte[0].xy - texel * matte[0].z), length(matte[1].xy - texel * matte[1].z));
    return ivec2(clamp(ceil(stretch / abs(matte[2].z) * 1.25), vec2(1.0), vec2(float(FINE))));
}

// Whether all of a pixel lies within the limits of the card.
bool is_within(vec4 place, mat2x3 pixel_world) {
    float room = 1.0;
    for (int index = 0; index < LIMITS; ++index) {
        vec2 slope = abs(u_limits[index].xyz * pixel_world);
        room = min(room, dot(u_limits[index], place) - 0.5 * (slope.x + slope.y));
    }
    return room > 0.0;
}
#endif

// Where the middle of a cell lies in its pixel.
vec2 cell_middle(int index, ivec2 cells, vec2 cell) {
    // Whole numbers are divided one after the other, others side by side.
    float row = floor((float(index) + 0.5) * cell.x);
    return (vec2(float(index) - row * float(cells.x), row) + 0.5) * cell - 0.5;
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uvec4 record = texelFetch(u_pixels, ivec2(gl_FragCoord.xy), 0);
    int first = part_triangle(record, 0);
    vec4 plane = plane_of(max(first, 1));
    mat3x4 places = places_on(plane, pixel);
    vec3 middle = places[2].xyz;
    mat2x3 pixel_world = pixel_over(places);
    bool alone = part_mask(record, 0) == WHOLE;
    float height = dot(u_ground, places[2]) + TIE_PX;
    vec2 slope = abs(u_ground.xyz * pixel_world);
    // Where the ground comes through, samples add up with those of the ground (meshes/past.frag).
    bool finely = abs(height) < 0.5 * (slope.x + slope.y);
    int state = LIT;
#ifdef MESHES
    state = light_state(middle, plane.xyz, pixel_world);
    finely = finely || (alone && state == EDGE);
#endif
    float sum = 0.0;
    ivec2 cells = ivec2(1);
    bool evenly = false;
#ifndef OWN_SHADOW
    // Mostly one surface is seen, and nothing but the card's edge differs within the pixel.
    evenly = alone && !finely && height > 0.0 && u_region_count == 0;
#ifdef FULL
    sum = 1.0;
#else
    mat3 matte = on_matte(places);
    cells = cells_of(matte);
    evenly = evenly && is_within(places[2], pixel_world);
    vec2 share = 1.0 / vec2(cells);
    int even_count = evenly ? cells.x * cells.y : 0;
    for (int index = 0; index < even_count; ++index) {
        vec2 offset = cell_middle(index, cells, share);
        sum += alpha_coverage(matte[2] + matte[0] * offset.x + matte[1] * offset.y,
                              matte[0] * share.x, matte[1] * share.y) * share.x * share.y;
    }
#endif
    bool receives = (int(triangle_part(max(first, 1), 0).w) & RECEIVES) != 0;
    sum = evenly && receives && state == LIT ? sum * strength_at(plane.xyz, middle) : 0.0;
#endif
    int parts = part_mask(record, 1) == 0 ? 1 : part_mask(record, 2) == 0 ? 2 : PARTS;
    cells = finely ? ivec2(FINE) : alone ? cells : ivec2(parts, 1);
    bool in_parts = !finely && !alone;
    vec2 cell = in_parts ? vec2(1.0) : 1.0 / vec2(cells);
    int count = evenly ? 0 : cells.x * cells.y;
    for (int index = 0; index < count; ++index) {
        int part = in_parts ? index : alone ? 0 : part_with(record, 1 << index);
        int mask = part < PARTS ? part_mask(record, part) : 0;
        if (mask != 0) {
            int triangle = part_triangle(record, part);
            vec4 own = alone ? plane : plane_of(triangle);
            vec2 offset = in_parts ? sample_offset(first_of(mask))
                        : finely ? sample_offset(index) : cell_middle(index, cells, cell);
            float weight = in_parts ? count_of(mask) / 16.0 : cell.x * cell.y;
            // Another surface of the pixel is lit as the first one where it goes on from there.
            bool goes_on = abs(dot(plane, vec4(met(own, pixel + offset), 1.0))) < 0.5 && dot(plane.xyz, own.xyz) > 0.9;
            sum += part_shade(triangle, own, pixel + offset, cell, alone || goes_on ? state : EDGE) * weight;
        }
    }
    o_coverage = first == 0 ? 0.0 : sum;
}
