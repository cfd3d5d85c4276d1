#version 330 core
// The alpha of a shadow layer: covered part times opacity.

uniform sampler2D u_coverage;
uniform float u_opacity;

out float o_alpha;

void main() {
    o_alpha = texelFetch(u_coverage, ivec2(gl_FragCoord.xy), 0).r * u_opacity;
}
