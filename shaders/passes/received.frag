#version 330 core
// The shadow on a card, cut to the drawing that stands there: to its alpha, and to one piece of the card. Switches:
//   LIMITS   how many edges the piece has
//   MOVED    the drawing's texels do not fall on pixels; wants ONE_CHANNEL as well

#include "common/edge.glsl"

uniform sampler2D u_coverage;      // of the canvas' size
uniform sampler2D u_alpha;         // the drawing's, one texel a px
#if LIMITS > 0
uniform vec4 u_limits[LIMITS];     // signed distances in canvas px, >= 0 within the piece
#endif

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
    float part = 1.0;
#if LIMITS > 0
    for (int index = 0; index < LIMITS; ++index) {
        vec3 edge = u_limits[index].xyz;
        float away = dot(edge, vec3(gl_FragCoord.xy, 1.0));
        // Upright and level edges cut a pixel in two rectangles.
        part *= edge.x * edge.y == 0.0 ? clamp(away + 0.5, 0.0, 1.0) : cell_coverage(away, edge.xy);
    }
#endif
    o_alpha = texelFetch(u_coverage, here, 0).r * alpha_here() * part;
}
