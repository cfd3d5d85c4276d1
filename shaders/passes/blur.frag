#version 330 core
// One direction of a Gaussian in a band of a receiver; the width is that of the row it is summed up for (spec 3).
// ALONG_V sums along v, across the contact line, and goes first: all texels of a row have one width, so that the second
// direction may take its result as it is.

#include "passes/blur_width.glsl"

// REACH: how many texels are summed up on either side.

uniform sampler2D u_source;
uniform vec4 u_band;           // first and last texel of the band in x and y: x0, y0, x1, y1
uniform float u_first_v_px;    // v at the lower border of the row u_first_row
uniform float u_first_row;
uniform float u_texel_px;
uniform float u_least_sigma;   // texels

out float o_value;

#ifdef ALONG_V
const ivec2 STEP = ivec2(0, 1);
#else
const ivec2 STEP = ivec2(1, 0);
#endif

// A band is empty at its borders, so that going on with them is the same as finding nothing beyond.
float value_at(ivec2 texel, ivec4 band) {
#ifdef ALONG_V
    texel.y = clamp(texel.y, band.y, band.w);
#else
    texel.x = clamp(texel.x, band.x, band.z);
#endif
    return texelFetch(u_source, texel, 0).r;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec4 band = ivec4(u_band);
    float v = u_first_v_px + (gl_FragCoord.y - u_first_row) * u_texel_px;
    float sigma = sigma_at(v) / u_texel_px;
    // Texels are means over their own width, and a cubic spline will widen them again: 1/12 and 1/3 of a texel squared.
    float variance = max(sigma * sigma - 5.0 / 12.0, u_least_sigma * u_least_sigma);
    // The weights exp(-i²/2σ²) one from the other: their ratios are again a Gaussian's, with one constant ratio.
    float weight = 1.0;
    float ratio = exp(-0.5 / variance);
    float change = ratio * ratio;
    float sum = value_at(here, band);
    float weights = 1.0;
    for (int i = 1; i <= REACH; ++i) {
        weight *= ratio;
        ratio *= change;
        sum += weight * (value_at(here - STEP * i, band) + value_at(here + STEP * i, band));
        weights += 2.0 * weight;
    }
    // Where the shadow ends before the Gaussian does, only the shadow's part of it has been summed up.
    o_value = sum / max(weights, sqrt(6.2831853 * variance));
}
