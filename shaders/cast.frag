#version 330 core
// The shadow of one card piece from one light on one flat receiver (paper 3.4, in closed form).
// Writes the covered part of each pixel, 0 to 1.

#include "edge.glsl"
#include "grazing.glsl"

uniform sampler2D u_matte;             // alpha of the drawing, with a rim of empty texels
uniform vec2 u_origin_px;              // canvas px around which the forms below are given, for precision
uniform mat3 u_texel_from_pixel;       // canvas px - origin -> matte texels, texel centres at +0.5
uniform vec3 u_side;                   // signed distances in px, >= 0 on the shadow's side of the card ...
uniform vec3 u_left_fold;              // ... and between the folds of the piece
uniform vec3 u_right_fold;
uniform int u_max_cells;               // most cells a pixel is split into, each way
uniform int u_last_level;              // coarsest mipmap of the matte
uniform bool u_translucent;            // alpha casts as it is; else its 0.5 level is the edge

out float o_coverage;

// Bilinear alpha and its slope per texel.
vec3 alpha_and_slope(vec2 texel) {
    ivec2 last = textureSize(u_matte, 0) - 1;
    vec2 place = texel - 0.5;
    vec2 corner = floor(place);
    vec2 f = place - corner;
    // The rim is empty, so clamping to it is the same as finding nothing outside.
    ivec2 low = clamp(ivec2(corner), ivec2(0), last);
    ivec2 high = clamp(ivec2(corner) + 1, ivec2(0), last);
    float a = texelFetch(u_matte, low, 0).r;
    float b = texelFetch(u_matte, ivec2(high.x, low.y), 0).r;
    float c = texelFetch(u_matte, ivec2(low.x, high.y), 0).r;
    float d = texelFetch(u_matte, high, 0).r;
    float top = mix(a, b, f.x);
    float bottom = mix(c, d, f.x);
    return vec3(mix(top, bottom, f.y), mix(b - a, d - c, f.y), bottom - top);
}

// Mean alpha around a texel for a matte that is squeezed hard; levels hold whole squares of 2^level texels.
float mean_alpha(vec2 texel, int level) {
    ivec2 square = ivec2(floor(texel)) >> level;
    bool inside = all(greaterThanEqual(square, ivec2(0))) && all(lessThan(square, textureSize(u_matte, level)));
    return inside ? texelFetch(u_matte, square, level).r : 0.0;
}

float matte_coverage(vec2 pixel) {
    vec3 h = u_texel_from_pixel * vec3(pixel, 1.0);
    vec2 texel = h.xy / h.z;
    // Columns: how far one canvas px in x and in y goes over the matte.
    mat2 step_texel = mat2(u_texel_from_pixel[0].xy - texel * u_texel_from_pixel[0].z,
                           u_texel_from_pixel[1].xy - texel * u_texel_from_pixel[1].z) / h.z;
    vec2 stretch = vec2(length(step_texel[0]), length(step_texel[1]));
    ivec2 cells = ivec2(clamp(ceil(stretch), vec2(1.0), vec2(float(u_max_cells))));
    float left_over = max(stretch.x / float(cells.x), stretch.y / float(cells.y));
    int level = left_over > 1.0 ? min(int(ceil(log2(left_over))), u_last_level) : 0;
    vec2 cell = 1.0 / vec2(cells);
    float sum = 0.0;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            vec2 inside = (vec2(float(x), float(y)) + 0.5) * cell - 0.5;
            vec3 at = u_texel_from_pixel * vec3(pixel + inside, 1.0);
            if (level > 0) {
                sum += mean_alpha(at.xy / at.z, level);
                continue;
            }
            vec3 alpha = alpha_and_slope(at.xy / at.z);
            if (u_translucent) {
                sum += alpha.x;
            } else {
                vec2 slope = vec2(dot(alpha.yz, step_texel[0]), dot(alpha.yz, step_texel[1])) * cell;
                sum += cell_coverage(alpha.x - 0.5, slope);
            }
        }
    }
    return sum * cell.x * cell.y;
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    vec3 place = vec3(pixel, 1.0);
    float side = cell_coverage(dot(u_side, place), u_side.xy);
    float folds = cell_coverage(dot(u_left_fold, place), u_left_fold.xy)
                * cell_coverage(dot(u_right_fold, place), u_right_fold.xy);
    o_coverage = 0.0;
    if (side * folds > 0.0) {
        o_coverage = min(matte_coverage(pixel), side) * folds * grazing_strength(pixel);
    }
}
