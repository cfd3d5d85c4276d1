#version 330 core
// One direction of a Gaussian in bands of a receiver; the width is that of the row it is summed up for (spec 3).
// Switches:
//   ALONG_V   sums along v, across the contact line, and goes first: all texels of a row have one width, so that the
//             second direction may take its result as it is
//   STRIPS    how many bands there may be

#include "passes/blur_width.glsl"

flat in int v_strip;

uniform sampler2D u_source;
uniform vec4 u_strips[STRIPS];   // v at the lower border of the band's first row, that row, px of a texel; and what
                                 // texels and their spline blur besides, texels squared
uniform vec4 u_ranges[STRIPS];   // first and last texel that may hold anything: x0, y0, x1, y1

const float LEAST_VARIANCE = 0.09;
const float REACH_SIGMAS = 3.2;

out float o_value;

#ifdef ALONG_V
const ivec2 STEP = ivec2(0, 1);
#else
const ivec2 STEP = ivec2(1, 0);
#endif

// The weights exp(-i²/2σ²) one from the other: their ratios are again a Gaussian's, with one constant ratio. Outward
// from the middle, so that what is rounded off adds up only where the weights are small.
float on_one_side(ivec2 here, ivec2 way, int first, int last, float variance) {
    float start = float(first);
    float weight = exp(-0.5 * start * start / variance);
    float ratio = exp(-(start + 0.5) / variance);
    float change = exp(-1.0 / variance);
    float sum = 0.0;
    for (int i = first; i <= last; ++i) {
        sum += weight * texelFetch(u_source, here + way * i, 0).r;
        weight *= ratio;
        ratio *= change;
    }
    return sum;
}

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 strip = u_strips[v_strip];
    ivec4 range = ivec4(u_ranges[v_strip]);
    float sigma = sigma_at(strip.x + (gl_FragCoord.y - strip.y) * strip.z) / strip.z;
    float variance = max(sigma * sigma - strip.w, LEAST_VARIANCE);
    int reach = int(ceil(REACH_SIGMAS * sqrt(variance)));
#ifdef ALONG_V
    int first = max(here.y - reach, range.y) - here.y;
    int last = min(here.y + reach, range.w) - here.y;
#else
    int first = max(here.x - reach, range.x) - here.x;
    int last = min(here.x + reach, range.z) - here.x;
#endif
    float sum = on_one_side(here, STEP, max(first, 0), last, variance)
              + on_one_side(here, -STEP, max(-last, 1), -first, variance);
    // Of a narrow Gaussian the samples do not add up to its integral.
    float next = exp(-0.5 / variance);
    float samples = 1.0 + 2.0 * (next + pow(next, 4.0) + pow(next, 9.0));
    o_value = sum / max(samples, sqrt(6.2831853 * variance));
}
