#version 330 core
// How a reflection is coloured and how far it is seen: straight colour and alpha. Switches:
//   BEHIND_PIECES   pieces of the set hide ground
//   AS_IT_IS        only copies

#include "common/look.glsl"

uniform sampler2D u_mirrored;          // colour times alpha, and alpha
uniform vec3 u_color;
uniform float u_tone;                  // how much of that colour it takes on
uniform float u_opacity;
#ifdef BEHIND_PIECES
uniform sampler2D u_ground;            // the part of each pixel in which the ground is seen
#endif

out vec4 o_color;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 mirrored = texelFetch(u_mirrored, here, 0);
#ifdef AS_IT_IS
    o_color = mirrored;
#else
    float alpha = mirrored.a * opacity_at(gl_FragCoord.xy, u_opacity);
#ifdef BEHIND_PIECES
    alpha *= texelFetch(u_ground, here, 0).r;
#endif
    o_color = alpha > 0.0 ? vec4(mix(mirrored.rgb / mirrored.a, u_color, u_tone), alpha) : vec4(0.0);
#endif
}
