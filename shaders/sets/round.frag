#version 330 core
// The shadow on a ball or on the side of a drum, as if it were seen whole; sets/mask.frag cuts it to what is seen.
// Every cell of a pixel is met with the surface, and from there with the card and with the other bodies. All forms are
// over the world around the middle of the body. Switches:
//   TRANSLUCENT        alpha casts as it is; else its 0.5 level is the edge
//   OWN_SHADOW         writes what the set takes from the light instead; the body casts, too, with ...
//   DARK_WHEN_TURNED   ... this
//   MESHES             meshes take the light, too

#include "common/edge.glsl"
#include "sets/occlusion_cones.glsl"
#include "sets/round_surface.glsl"
#ifndef OWN_SHADOW
#include "common/card_in_space.glsl"
#endif
#ifdef MESHES
#include "meshes/light.glsl"
#endif

uniform vec4 u_light;
uniform vec4 u_axis;                   // a drum's axis and half its height; zero for a ball
uniform vec2 u_grazing_sine;

out float o_coverage;

const int CELLS = 2;
const float CELL = 1.0 / float(CELLS);
const float END_MARGIN_PX = 3.0;       // the rims of a drum's ends are sets/mask.frag's matter

float cell_shade(vec2 pixel, mat2x3 cell_world) {
    vec3 here = surface_at(pixel);
    float height = dot(u_axis.xyz, here);
    if (abs(height) > u_axis.w + END_MARGIN_PX) {
        return 0.0;
    }
    vec4 place = vec4(here, 1.0);
    vec3 toward = u_light.xyz - u_light.w * here;
    vec3 normal = u_across * here / u_radius;
    float sine = dot(normal, toward) / length(toward);
    float strength = smoothstep(u_grazing_sine.x, u_grazing_sine.y, sine);
    vec2 left = seen_and_lit(place, cell_world);
#ifdef MESHES
    left.y *= mesh_lit(here, normal, cell_world, 2, WHOLE);
#endif
#if defined(DARK_WHEN_TURNED)
    return left.x * (1.0 - strength * left.y);
#elif defined(OWN_SHADOW)
    return left.x * strength * (1.0 - left.y);
#else
    return strength > 0.0 ? left.x * left.y * strength * cast_coverage(place, cell_world) : 0.0;
#endif
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    mat2x3 cell_world = mat2x3(surface_at(pixel + vec2(0.5, 0.0)) - surface_at(pixel - vec2(0.5, 0.0)),
                               surface_at(pixel + vec2(0.0, 0.5)) - surface_at(pixel - vec2(0.0, 0.5)));
    cell_world = mat2x3(cell_world[0] * CELL, cell_world[1] * CELL);
    float sum = 0.0;
    for (int y = 0; y < CELLS; ++y) {
        for (int x = 0; x < CELLS; ++x) {
            sum += cell_shade(pixel + (vec2(float(x), float(y)) + 0.5) * CELL - 0.5, cell_world);
        }
    }
    o_coverage = sum * CELL * CELL;
}
