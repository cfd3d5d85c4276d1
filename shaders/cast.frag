#version 330 core
// The shadow of one card piece from one light on one flat receiver (paper 3.4, in closed form).
// Writes the covered part of each pixel, 0 to 1.

#include "edge.glsl"

uniform sampler2D u_matte;             // alpha of the drawing, with a rim of empty texels
uniform vec2 u_origin_px;              // canvas px around which the forms below are given, for precision
uniform mat3 u_texel_from_pixel;       // canvas px - origin -> matte texels, texel centres at +0.5
uniform mat3 u_receiver_from_pixel;    // canvas px - origin -> receiver (u, v) in px
uniform vec3 u_side;                   // signed distances in px, >= 0 on the shadow's side of the card ...
uniform vec3 u_left_fold;              // ... and between the folds of the piece
uniform vec3 u_right_fold;
uniform int u_max_cells;               // most cells a pixel is split into, each way
uniform bool u_translucent;            // alpha casts as it is; else its 0.5 level is the edge
uniform float u_strength;              // of a light low over the whole receiver (the sun)
uniform bool u_is_lamp;
uniform vec3 u_lamp_on_receiver;       // the lamp's foot (u, v) and its height, px
uniform vec2 u_grazing_sine;           // sines of the low angles between which a lamp's shadow fades in

out float o_coverage;

float alpha_at(ivec2 texel, int level, ivec2 size) {
    return texelFetch(u_matte, clamp(texel, ivec2(0), size - 1), level).r;
}

// Bilinear alpha and its slope per texel of level 0.
vec3 alpha_and_slope(vec2 texel, int level) {
    ivec2 size = textureSize(u_matte, level);
    vec2 scale = level == 0 ? vec2(1.0) : vec2(size) / vec2(textureSize(u_matte, 0));
    vec2 place = texel * scale - 0.5;
    vec2 corner = floor(place);
    vec2 f = place - corner;
    ivec2 i = ivec2(corner);
    float a = alpha_at(i, level, size);
    float b = alpha_at(i + ivec2(1, 0), level, size);
    float c = alpha_at(i + ivec2(0, 1), level, size);
    float d = alpha_at(i + ivec2(1, 1), level, size);
    float top = mix(a, b, f.x);
    float bottom = mix(c, d, f.x);
    return vec3(mix(top, bottom, f.y), mix(b - a, d - c, f.y) * scale.x, (bottom - top) * scale.y);
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
    int level = left_over > 1.5 ? int(ceil(log2(left_over) - 0.5)) : 0;
    vec2 cell = 1.0 / vec2(cells);
    float sum = 0.0;
    for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x) {
            vec2 inside = (vec2(float(x), float(y)) + 0.5) * cell - 0.5;
            vec3 at = u_texel_from_pixel * vec3(pixel + inside, 1.0);
            vec3 alpha = alpha_and_slope(at.xy / at.z, level);
            if (u_translucent || level > 0) {
                sum += alpha.x;
            } else {
                vec2 slope = vec2(dot(alpha.yz, step_texel[0]), dot(alpha.yz, step_texel[1])) * cell;
                sum += cell_coverage(alpha.x - 0.5, slope);
            }
        }
    }
    return sum * cell.x * cell.y;
}

float lamp_strength(vec2 pixel) {
    vec3 h = u_receiver_from_pixel * vec3(pixel, 1.0);
    vec2 away = h.xy / h.z - u_lamp_on_receiver.xy;
    float height = u_lamp_on_receiver.z;
    return smoothstep(u_grazing_sine.x, u_grazing_sine.y, height * inversesqrt(height * height + dot(away, away)));
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    vec3 place = vec3(pixel, 1.0);
    float side = cell_coverage(dot(u_side, place), u_side.xy);
    float fold = clamp(min(dot(u_left_fold, place), dot(u_right_fold, place)) + 1.0, 0.0, 1.0);
    float limit = min(side, fold);
    if (limit == 0.0) {
        discard;
    }
    float coverage = min(matte_coverage(pixel), limit) * u_strength;
    if (u_is_lamp && coverage > 0.0) {
        coverage *= lamp_strength(pixel);
    }
    o_coverage = coverage;
}
