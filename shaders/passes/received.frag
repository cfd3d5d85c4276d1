#version 330 core
// The shadow on a card, cut to the drawing that stands there: to its alpha, and to the columns of one piece of the card.

uniform sampler2D u_coverage;      // of the canvas' size
uniform sampler2D u_alpha;         // the drawing's, one texel a px
uniform vec2 u_corner_px;          // canvas px of its first texel
uniform vec2 u_columns_px;         // where the piece begins and ends

out float o_alpha;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    float left = float(here.x);
    float part = clamp(min(left + 1.0, u_columns_px.y) - max(left, u_columns_px.x), 0.0, 1.0);
    float alpha = texelFetch(u_alpha, here - ivec2(u_corner_px), 0).r;
    o_alpha = texelFetch(u_coverage, here, 0).r * alpha * part;
}
