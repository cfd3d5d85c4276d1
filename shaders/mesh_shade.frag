#version 330 core
// The shadow on the meshes: every part of a pixel is met with the triangle seen there, and from there with the card and
// with what takes the light. Switches:
//   TRANSLUCENT   see card_in_space.glsl
//   OWN_SHADOW    writes what the set takes from the light instead; those meshes that cast grow dark when turned away
//   MESHES        the meshes take the light, too

#include "edge.glsl"
#include "veils.glsl"
#include "mesh_surface.glsl"
#ifndef OWN_SHADOW
#include "card_in_space.glsl"
#endif
#ifdef MESHES
#include "mesh_light.glsl"
#endif

uniform vec4 u_ground;                 // hides what lies below it; positive on the side of the eye
uniform vec4 u_light;                  // homogeneous
uniform vec2 u_grazing_sine;

out float o_coverage;

const int RECEIVES = 1, CASTS = 2;
const int FINE = 4;                    // into how many parts a pixel may be split, each way

float part_shade(int triangle, vec4 plane, vec2 pixel, float cell, int finer) {
    vec3 here = met(plane, pixel);
    mat2x3 cell_world = pixel_on(plane, pixel) * cell;
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
    float wanted = (flags & RECEIVES) == 0 ? 0.0 : left.x * left.y * strength * cast_coverage(place, cell_world);
#endif
    float lit = 1.0;
#ifdef MESHES
    if (wanted > 0.0) {
        lit = mesh_lit(here, plane.xyz, cell_world, finer, ALL_PARTS);
    }
#endif
#ifdef OWN_SHADOW
    return casts ? left.x * (1.0 - strength * left.y * lit) : wanted * (1.0 - left.y * lit);
#else
    return wanted * lit;
#endif
}

// Into how many cells each way a pixel is split: about one a texel of the drawing.
int cells_of(vec4 plane, vec2 pixel) {
#ifdef OWN_SHADOW
    return 1;
#else
    mat2x3 step_world = pixel_on(plane, pixel);
    vec3 h = projected(vec4(met(plane, pixel), 1.0));
    vec2 texel = h.xy / h.z;
    vec3 step_x = projected(vec4(step_world[0], 0.0)), step_y = projected(vec4(step_world[1], 0.0));
    float stretch = max(length(step_x.xy - texel * step_x.z), length(step_y.xy - texel * step_y.z)) / abs(h.z);
    return int(clamp(ceil(stretch * 1.25), 1.0, float(FINE)));
#endif
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uint record = texelFetch(u_pixels, at, 0).r;
    bool several = (record & SEVERAL) != 0u;
    int middle = int(record & ~SEVERAL);
    vec4 plane = plane_of(max(middle, 1));
    float height = dot(u_ground, vec4(met(plane, pixel), 1.0)) + TIE_PX;
    vec2 slope = abs(u_ground.xyz * pixel_on(plane, pixel));
    // Where the ground comes through, parts of the pixel add up with those of the ground (mesh_past.frag).
    bool at_ground = abs(height) < 0.5 * (slope.x + slope.y);
    int side = several ? u_side : at_ground ? FINE : cells_of(plane, pixel);
    int count = middle == 0 ? 0 : side * side;
    float cell = 1.0 / float(side);
    float sum = 0.0;
    for (int index = 0; index < count; ++index) {
        int triangle = several ? sample_at(at, index) : middle;
        if (triangle > 0) {
            vec4 own = several ? plane_of(triangle) : plane;
            sum += part_shade(triangle, own, pixel + sample_offset(index, side), cell, max(FINE / side, 1));
        }
    }
    o_coverage = sum * cell * cell;
}
