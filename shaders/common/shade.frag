#version 330 core
// A shadow layer: covered part times opacity as its alpha; with TINTED also its colour (common/look.glsl), straight.
// With MOST_TAKEN besides, instead of the colour what is taken of each part of white, for several to unite by maximum.

#include "common/look.glsl"

uniform sampler2D u_coverage;
uniform float u_opacity;

#ifdef TINTED
uniform vec3 u_color;

out vec4 o_color;
#else
out float o_alpha;
#endif

void main() {
    float alpha = texelFetch(u_coverage, ivec2(gl_FragCoord.xy), 0).r * opacity_at(gl_FragCoord.xy, u_opacity);
#ifdef MOST_TAKEN
    o_color = vec4(alpha * (1.0 - color_at(gl_FragCoord.xy, u_color)), alpha);
#elif defined(TINTED)
    o_color = vec4(color_at(gl_FragCoord.xy, u_color), alpha);
#else
    o_alpha = alpha;
#endif
}
