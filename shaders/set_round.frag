#version 330 core
// The shadow on a ball or on the side of a drum, as if it were seen whole; set_mask.frag cuts it to what is seen.
// Every cell of a pixel is met with the surface, and from there with the card and with the other bodies. All forms are
// over the world around the middle of the body. Switches:
//   TRANSLUCENT        alpha casts as it is; else its 0.5 level is the edge
//   OWN_SHADOW         writes what the set takes from the light instead; the body casts, too, with ...
//   DARK_WHEN_TURNED   ... this

#include "edge.glsl"

uniform vec2 u_origin_px;              // canvas px around which pixels are counted
uniform vec3 u_origin_world;           // the same point of the drawing's plane, around the middle of the body
uniform vec4 u_eye;                    // homogeneous, around the middle of the body
uniform vec4 u_light;
uniform mat3 u_across;                 // the body's surface is where Y across Y = radius²
uniform float u_radius;
uniform vec4 u_axis;                   // a drum's axis and half its height; zero for a ball
uniform vec2 u_grazing_sine;

uniform vec4 u_regions[MAX_REGIONS];   // cones of other bodies: first plane, behind the last, quadric or -1, flags
uniform vec4 u_planes[MAX_LINES];
uniform vec4 u_quadrics[4 * MAX_CONICS];
uniform int u_region_count;

#ifndef OWN_SHADOW
uniform sampler2D u_matte;             // texels and their neighbours, with a rim of empty ones
uniform vec4 u_texel_rows[3];          // from the world to matte texels
uniform vec4 u_limits[3];              // the card's side and its two folds, >= 0 where the piece casts
#endif

out float o_coverage;

const int CELLS = 2;
const float CELL = 1.0 / float(CELLS);
const float END_MARGIN_PX = 3.0;       // the rims of a drum's ends are set_mask.frag's matter

const int LAST = 1, OVERLAPS = 2, LIGHT = 8;

vec3 surface_at(vec2 pixel) {
    vec3 start = u_origin_world + vec3(pixel, 0.0);
    vec3 along = u_eye.w == 0.0 ? -u_eye.xyz : start - u_eye.xyz;
    vec3 bent = u_across * along;
    float a = dot(along, bent);
    // From the point of the ray nearest to the axis, so that no large numbers cancel.
    start -= along * (dot(start, bent) / a);
    float inside = u_radius * u_radius - dot(start, u_across * start);
    return start - along * sqrt(max(inside, 0.0) / a);
}

float edge_of(float value, vec2 slope) {
    float steep = max(length(slope), 1e-30);
    return cell_coverage(value / steep, slope / steep * CELL);
}

float region_coverage(vec4 region, vec4 place, mat2x3 step_world) {
    float covered = 1.0;
    for (int index = int(region.x); index < int(region.y); ++index) {
        vec4 plane = u_planes[index];
        covered *= edge_of(dot(plane, place), plane.xyz * step_world);
    }
    if (region.z >= 0.0) {
        int row = 4 * int(region.z);
        vec4 bent = vec4(dot(u_quadrics[row], place), dot(u_quadrics[row + 1], place),
                         dot(u_quadrics[row + 2], place), dot(u_quadrics[row + 3], place));
        covered *= edge_of(dot(bent, place), 2.0 * bent.xyz * step_world);
    }
    return covered;
}

// Seen part and lit part.
vec2 seen_and_lit(vec4 place, mat2x3 step_world) {
    vec2 left = vec2(1.0);
    float taken = 0.0;
    for (int index = 0; index < u_region_count; ++index) {
        vec4 region = u_regions[index];
        int flags = int(region.w);
        float covered = region_coverage(region, place, step_world);
        taken = (flags & OVERLAPS) != 0 ? max(taken, covered) : min(taken + covered, 1.0);
        if ((flags & LAST) != 0) {
            left *= (flags & LIGHT) != 0 ? vec2(1.0, 1.0 - taken) : vec2(1.0 - taken, 1.0);
            taken = 0.0;
        }
    }
    return left;
}

#ifndef OWN_SHADOW
vec3 alpha_and_slope(vec2 texel) {
    vec2 place = texel - 0.5;
    vec2 corner = floor(place);
    vec2 f = place - corner;
    // The rim is empty, so clamping to it is the same as finding nothing outside.
    vec4 a = texelFetch(u_matte, clamp(ivec2(corner), ivec2(0), textureSize(u_matte, 0) - 1), 0);
    vec2 rows = mix(a.xz, a.yw, f.x);
    return vec3(mix(rows.x, rows.y, f.y), mix(a.y - a.x, a.w - a.z, f.y), rows.y - rows.x);
}

vec3 projected(vec4 place) {
    return vec3(dot(u_texel_rows[0], place), dot(u_texel_rows[1], place), dot(u_texel_rows[2], place));
}

float cast_coverage(vec4 place, mat2x3 step_world) {
    vec3 h = projected(place);
    if (h.z <= 0.0) {
        return 0.0;
    }
    vec2 texel = h.xy / h.z;
    vec3 alpha = alpha_and_slope(clamp(texel, vec2(-1e6), vec2(1e6)));
#ifdef TRANSLUCENT
    float covered = alpha.x;
#else
    vec3 step_x = projected(vec4(step_world[0], 0.0)), step_y = projected(vec4(step_world[1], 0.0));
    vec2 slope = vec2(dot(alpha.yz, (step_x.xy - texel * step_x.z) / h.z),
                      dot(alpha.yz, (step_y.xy - texel * step_y.z) / h.z)) * CELL;
    float covered = cell_coverage(alpha.x - 0.5, slope);
#endif
    for (int index = 0; index < 3; ++index) {
        covered *= edge_of(dot(u_limits[index], place), u_limits[index].xyz * step_world);
    }
    return covered;
}
#endif

float cell_shade(vec2 pixel, mat2x3 step_world) {
    vec3 here = surface_at(pixel);
    float height = dot(u_axis.xyz, here);
    if (abs(height) > u_axis.w + END_MARGIN_PX) {
        return 0.0;
    }
    vec4 place = vec4(here, 1.0);
    vec3 toward = u_light.xyz - u_light.w * here;
    float sine = dot(u_across * here, toward) / (u_radius * length(toward));
    float strength = smoothstep(u_grazing_sine.x, u_grazing_sine.y, sine);
    vec2 left = seen_and_lit(place, step_world);
#if defined(DARK_WHEN_TURNED)
    return left.x * (1.0 - strength * left.y);
#elif defined(OWN_SHADOW)
    return left.x * strength * (1.0 - left.y);
#else
    return strength > 0.0 ? left.x * left.y * strength * cast_coverage(place, step_world) : 0.0;
#endif
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    mat2x3 step_world = mat2x3(surface_at(pixel + vec2(0.5, 0.0)) - surface_at(pixel - vec2(0.5, 0.0)),
                               surface_at(pixel + vec2(0.0, 0.5)) - surface_at(pixel - vec2(0.0, 0.5)));
    float sum = 0.0;
    for (int y = 0; y < CELLS; ++y) {
        for (int x = 0; x < CELLS; ++x) {
            sum += cell_shade(pixel + (vec2(float(x), float(y)) + 0.5) * CELL - 0.5, step_world);
        }
    }
    o_coverage = sum * CELL * CELL;
}
