#version 330 core
// What one card piece of a figure shows of a cel in the ground, as a mirror does: colour times alpha, and alpha.
// Switches:
//   LIMITS   how many edges the piece has
//   WAVES    the ground moves, see common/waves.glsl
//   HARD     a pixel shows one texel, in full or not at all

#include "common/between_texels.glsl"
#include "common/edge.glsl"

uniform sampler2D u_cel;
uniform vec2 u_origin_px;              // canvas px around which all that follows is given, for precision
uniform vec3 u_side;                   // signed distances in px, >= 0 on the mirroring side of the card's contact line ...
#if LIMITS > 0
uniform vec4 u_limits[LIMITS];         // ... and within the edges of the piece (x, y, 1)
#endif
uniform vec3 u_horizon;                // >= 0 where the ground is seen at all

out vec4 o_color;

#ifdef WAVES
#include "common/waves.glsl"

uniform mat3 u_place_from_pixel;       // to u and v on the ground, v from the contact line ...
uniform mat3 u_pixel_from_place;       // ... and back
#endif

float within(vec3 edge, vec2 pixel, vec2 cell) {
    return cell_coverage(dot(edge, vec3(pixel, 1.0)), edge.xy * cell);
}

// What is seen at a place of the canvas that the waves do not move.
vec4 mirrored(vec2 here, vec2 cell) {
    float part = within(u_side, here, cell);
#if LIMITS > 0
    for (int index = 0; index < LIMITS; ++index) {
        part *= within(u_limits[index].xyz, here, cell);
    }
#endif
    vec3 texel = u_texel_from_pixel * vec3(here, 1.0);
    // Beyond that the mirrored ray never comes to the card's plane.
#ifdef HARD
    vec4 nearest = weighted_texel(u_cel, ivec2(floor(texel.xy / texel.z)));
    bool seen = texel.z > 0.0 && part >= 0.5 && nearest.a >= 0.5;
    return seen ? vec4(nearest.rgb / nearest.a, 1.0) : vec4(0.0);
#else
    return texel.z > 0.0 ? part * between_texels(u_cel, texel.xy / texel.z) : vec4(0.0);
#endif
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    vec2 cell = vec2(1.0 / float(u_cells));
    vec4 sum = vec4(0.0);
    for (int y = 0; y < u_cells; ++y) {
        for (int x = 0; x < u_cells; ++x) {
            vec2 here = pixel + (vec2(float(x), float(y)) + 0.5) * cell - 0.5;
            float seen = step(0.0, dot(u_horizon, vec3(here, 1.0)));
#ifdef WAVES
            vec3 ground = u_place_from_pixel * vec3(here, 1.0);
            vec2 place = ground.xy / ground.z;
            moved_by_waves(place);
            vec3 moved = u_pixel_from_place * vec3(place, 1.0);
            seen *= step(1e-9, moved.z);
            here = moved.xy / moved.z;
#endif
            sum += seen * mirrored(here, cell);
        }
    }
    o_color = sum * cell.x * cell.y;
}
