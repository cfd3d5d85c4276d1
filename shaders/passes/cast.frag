#version 330 core
// The shadow of one card piece from one light on one flat receiver (paper 3.4, in closed form).
// Writes the covered part of each pixel, 0 to 1. Switches:
//   TRANSLUCENT   alpha casts as it is; else its 0.5 level is the edge
//   CELLS_X, _Y   how many cells a pixel is split into, each way: about one a texel
//   SQUEEZED      somewhere more texels fall on a pixel than cells can hold
//   AT_A_LIMIT    the card's contact line or an edge of the piece may cross these pixels
//   LIMITS        how many edges the piece has
//   PIECES        several pieces are drawn at once, with passes/cast_pieces.vert
//   ONE_LIMIT     ... of which only one end runs through these pixels
//   LAMP_IS_LOW   see common/grazing.glsl

#include "common/edge.glsl"
#include "common/grazing.glsl"

uniform sampler2D u_matte;             // alpha of the drawing: texels and their neighbours, with a rim of empty ones
uniform vec2 u_origin_px;              // canvas px around which the forms below are given, for precision
#ifdef PIECES
flat in mat3 v_texel_from_pixel;
#else
uniform mat3 u_texel_from_pixel;       // canvas px - origin -> matte texels, texel centres at +0.5
#endif

out float o_coverage;

#ifdef AT_A_LIMIT
#if defined(ONE_LIMIT)
flat in vec4 v_end;                    // as below, and whether it is an edge rather than the side
#elif defined(PIECES)
flat in vec3 v_side;
flat in vec3 v_edge_1;
flat in vec3 v_edge_2;
flat in vec3 v_edge_3;
flat in vec3 v_edge_4;
#else
uniform vec3 u_side;                   // signed distances in px, >= 0 on the shadow's side of the card ...
#endif
#if LIMITS > 0
uniform vec4 u_limits[LIMITS];         // ... and within the edges of the piece (x, y, 1)
#endif
uniform vec3 u_horizon;                // >= 0 where the receiver is seen at all

float within(vec3 edge, vec2 pixel, vec2 cell) {
    return cell_coverage(dot(edge, vec3(pixel, 1.0)), edge.xy * cell);
}
#endif

#ifdef SQUEEZED
uniform sampler2D u_means;             // the part of the matte that casts, mean over squares of 2^level texels
uniform int u_last_level;              // its coarsest mipmap

// What casts around a texel.
float mean_alpha(vec2 texel, int level) {
    ivec2 square = ivec2(floor(texel)) >> level;
    bool inside = all(greaterThanEqual(square, ivec2(0))) && all(lessThan(square, textureSize(u_means, level)));
    return inside ? texelFetch(u_means, square, level).r : 0.0;
}
#endif

// Bilinear alpha and its slope per texel.
vec3 alpha_and_slope(vec2 texel) {
    vec2 place = texel - 0.5;
    vec2 corner = floor(place);
    vec2 f = place - corner;
    // The rim is empty, so clamping to it is the same as finding nothing outside.
    vec4 a = texelFetch(u_matte, clamp(ivec2(corner), ivec2(0), textureSize(u_matte, 0) - 1), 0);
    vec2 rows = mix(a.xz, a.yw, f.x);
    return vec3(mix(rows.x, rows.y, f.y), mix(a.y - a.x, a.w - a.z, f.y), rows.y - rows.x);
}

float matte_coverage(vec2 pixel) {
#ifdef PIECES
    mat3 texel_from_pixel = v_texel_from_pixel;
#else
    mat3 texel_from_pixel = u_texel_from_pixel;
#endif
    vec3 h = texel_from_pixel * vec3(pixel, 1.0);
    vec2 texel = h.xy / h.z;
    // Columns: how far one canvas px in x and in y goes over the matte.
    mat2 step_texel = mat2(texel_from_pixel[0].xy - texel * texel_from_pixel[0].z,
                           texel_from_pixel[1].xy - texel * texel_from_pixel[1].z) / h.z;
    const ivec2 cells = ivec2(CELLS_X, CELLS_Y);
    const vec2 cell = 1.0 / vec2(cells);
#ifdef SQUEEZED
    vec2 left_over = vec2(length(step_texel[0]), length(step_texel[1])) * cell;
    int level = clamp(int(ceil(log2(max(left_over.x, left_over.y)))), 0, u_last_level);
#endif
    float sum = 0.0;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            vec2 inside = (vec2(float(x), float(y)) + 0.5) * cell - 0.5;
            vec3 place = h + texel_from_pixel[0] * inside.x + texel_from_pixel[1] * inside.y;
            vec2 at = place.xy / place.z;
            vec3 alpha = alpha_and_slope(at);
#ifdef TRANSLUCENT
            float covered = alpha.x;
#else
            vec2 slope = vec2(dot(alpha.yz, step_texel[0]), dot(alpha.yz, step_texel[1])) * cell;
            float covered = cell_coverage(alpha.x - 0.5, slope);
#endif
#ifdef SQUEEZED
            covered = level > 0 ? mean_alpha(at, level) : covered;
            // What lies behind the eye is not part of the drawing, wherever its projection falls.
            covered *= step(0.0, place.z);
#endif
#ifdef AT_A_LIMIT
            vec2 here = pixel + inside;
#if defined(ONE_LIMIT)
            float part = within(v_end.xyz, here, cell);
            covered = v_end.w == 0.0 ? min(covered, part) : covered * part;
#elif defined(PIECES)
            covered = min(covered, within(v_side, here, cell));
            covered *= within(v_edge_1, here, cell) * within(v_edge_2, here, cell);
            covered *= within(v_edge_3, here, cell) * within(v_edge_4, here, cell);
#else
            covered = min(covered, within(u_side, here, cell));
#endif
#if LIMITS > 0
            for (int index = 0; index < LIMITS; ++index) {
                covered *= within(u_limits[index].xyz, here, cell);
            }
#endif
            covered *= step(0.0, dot(u_horizon, vec3(here, 1.0)));
#endif
            sum += covered;
        }
    }
    return sum * cell.x * cell.y;
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    o_coverage = matte_coverage(pixel) * grazing_strength(pixel);
}
