#version 330 core
// The filtered shadow on the canvas: where the blurred one is over its level (spec 3). Switches:
//   WAVES   it is read where waves have moved it (paper 3.6.2, spec 4)
//   SLITS   waves leave gaps open in it (common/slits.glsl)
//   EDGE    its outline is moved outward, or its edge is wider than a pixel
//   JOINED  near seams it passes over into what other charts have of it (passes/joins.glsl)
//   LAMP_IS_LOW   see common/grazing.glsl

#include "common/edge.glsl"
#include "common/grazing.glsl"
#include "passes/blur_width.glsl"
#ifdef WAVES
#include "common/waves.glsl"
#endif
#ifdef SLITS
#include "common/slits.glsl"
#endif
#ifdef EDGE
#include "passes/wide_edge.glsl"
#endif
#ifdef JOINED
#include "passes/joins.glsl"
#endif

const int MAX_BANDS = 48;

uniform sampler2D u_blurred;
uniform sampler2D u_sharp;             // the shadow as it was cast, on the canvas
uniform vec2 u_origin_px;
uniform mat3 u_plane_from_pixel;       // canvas px - origin -> u along the contact line, v away from it
uniform vec2 u_bands;                  // the receiver's first band, and the one behind its last
uniform vec4 u_cores[MAX_BANDS];       // |v| from, |v| to, side of v (0: both), texel px
uniform vec4 u_places[MAX_BANDS];      // u and v at the band's corner, px; its corner in the atlas, texels
uniform vec4 u_sizes[MAX_BANDS];       // its size in texels; the rest is not used
uniform float u_level;
uniform vec2 u_pass_over_px;           // blurs between which the sharp shadow passes over into the blurred one

out float o_coverage;

vec4 spline(float f) {
    float g = 1.0 - f;
    return vec4(g * g * g, 4.0 - 6.0 * f * f + 3.0 * f * f * f, 4.0 - 6.0 * g * g + 3.0 * g * g * g, f * f * f) / 6.0;
}

vec4 spline_slope(float f) {
    float g = 1.0 - f;
    return vec4(-g * g, f * (3.0 * f - 4.0), g * (4.0 - 3.0 * g), f * f) / 2.0;
}

// Value and slope per texel of the cubic spline through a band.
vec3 value_and_slope(vec2 place, ivec2 corner, ivec2 size) {
    vec2 cell = floor(place - 0.5);
    vec2 f = place - 0.5 - cell;
    vec4 wx = spline(f.x);
    vec4 wy = spline(f.y);
    vec4 dx = spline_slope(f.x);
    vec4 dy = spline_slope(f.y);
    // A band is empty at its ends along the contact line, and holds more rows than are shown.
    ivec4 columns = clamp(int(cell.x) + ivec4(-1, 0, 1, 2), 0, size.x - 1) + corner.x;
    ivec4 rows = clamp(int(cell.y) + ivec4(-1, 0, 1, 2), 0, size.y - 1) + corner.y;
    vec3 sum = vec3(0.0);
    for (int j = 0; j < 4; ++j) {
        vec4 a = vec4(texelFetch(u_blurred, ivec2(columns.x, rows[j]), 0).r,
                      texelFetch(u_blurred, ivec2(columns.y, rows[j]), 0).r,
                      texelFetch(u_blurred, ivec2(columns.z, rows[j]), 0).r,
                      texelFetch(u_blurred, ivec2(columns.w, rows[j]), 0).r);
        float across = dot(a, wx);
        sum += vec3(across * wy[j], dot(a, dx) * wy[j], across * dy[j]);
    }
    return sum;
}

// Value of the blurred shadow at a place, where waves have moved it, and its slope there.
vec3 field_at(vec2 plane, vec2 bands) {
    vec2 here = plane;
    mat2 step_here = mat2(1.0);
#ifdef WAVES
    step_here = moved_by_waves(here);
#endif
    int band = -1;
    for (int i = int(bands.x); i < int(bands.y); ++i) {
        vec4 core = u_cores[i];
        bool inside = core.z == 0.0 || (abs(here.y) >= core.x && abs(here.y) < core.y && here.y * core.z >= 0.0);
        band = inside ? i : band;
    }
    if (band < 0) {
        return vec3(0.0);
    }
    float texel_px = u_cores[band].w;
    vec4 place = u_places[band];
    vec3 b = value_and_slope((here - place.xy) / texel_px, ivec2(place.zw), ivec2(u_sizes[band].xy));
    return vec3(b.x, (b.yz / texel_px) * step_here);
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    vec3 h = u_plane_from_pixel * vec3(pixel, 1.0);
    vec2 plane = h.xy / h.z;
    mat2 step_plane = mat2(u_plane_from_pixel[0].xy - plane * u_plane_from_pixel[0].z,
                           u_plane_from_pixel[1].xy - plane * u_plane_from_pixel[1].z) / h.z;
    vec3 field = field_at(plane, u_bands);
    float away = abs(plane.y);
#ifdef JOINED
    vec4 others = vec4(0.0);
    float shares = 0.0;
    float most = 0.0;
    float pixel_px = 1.5 * max(length(step_plane[0]), length(step_plane[1]));
    for (int i = 0; i < u_join_count; ++i) {
        float weight = join_weight(i, plane, pixel_px);
        if (weight > 0.0) {
            mat2 turn = join_turn(i);
            vec2 there = turn * plane + u_join_shifts[i].xy;
            vec3 other = field_at(there, u_join_bands[i].xy);
            others += join_share(weight) * vec4(other.x, other.yz * turn, abs(there.y));
            shares += join_share(weight);
            most = max(most, weight);
        }
    }
#ifdef EDGE
    // The inverse normal distribution takes the smallest slope for an edge, where there is but a passing over.
    vec2 passing = vec2(0.0);
#else
    vec2 passing = vec2(dFdx(most), dFdy(most)) * inverse(step_plane);
#endif
    if (shares > 0.0) {
        field = vec3(mix(field.x, others.x / shares, most),
                     mix(field.yz, others.yz / shares, most) + passing * (others.x / shares - field.x));
        away = mix(away, others.w / shares, most);
    }
#endif
    float blurred = 0.0;
    if (field.x > 0.0) {
        vec2 rise = field.yz;
        vec2 slope = rise * step_plane;
        // The slope of a wide blur is as small as one likes; only its direction and the distance to the level matter.
        float steep = max(length(slope), 1e-7);
#ifdef EDGE
        blurred = wide_edge(field.x, rise, slope / steep, steep, away);
#else
        blurred = cell_coverage((field.x - u_level) / steep, slope / steep);
#endif
    }
    float sharp = texelFetch(u_sharp, ivec2(gl_FragCoord.xy), 0).r;
    float shape = mix(sharp, blurred, smoothstep(u_pass_over_px.x, u_pass_over_px.y, sigma_at(away)));
#ifdef SLITS
    shape *= 1.0 - open_part(plane, step_plane);
#endif
    o_coverage = shape * grazing_strength(pixel);
}
