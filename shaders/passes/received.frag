#version 330 core
// The shadow on a card, cut to the drawing that stands there: to its alpha, and to the columns of one piece of the card.
// Switch:
//   MOVED   the drawing's texels do not fall on pixels

uniform sampler2D u_coverage;      // of the canvas' size
uniform sampler2D u_alpha;         // the drawing's, one texel a px
uniform vec2 u_columns_px;         // where the piece begins and ends

out float o_alpha;

#ifdef MOVED
#include "common/between_texels.glsl"

float alpha_here() {
    return moved_texel(u_alpha).a;
}
#else
uniform vec2 u_corner_px;          // canvas px of its first texel

float alpha_here() {
    return texelFetch(u_alpha, ivec2(gl_FragCoord.xy) - ivec2(u_corner_px), 0).r;
}
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float left = float(here.x);
    float part = clamp(min(left + 1.0, u_columns_px.y) - max(left, u_columns_px.x), 0.0, 1.0);
    o_alpha = texelFetch(u_coverage, here, 0).r * alpha_here() * part;
}
