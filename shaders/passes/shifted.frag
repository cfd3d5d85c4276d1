#version 330 core
// A picture moved by whole texels.

uniform sampler2D u_source;
uniform vec2 u_shift;

out float o_value;

void main() {
    o_value = texelFetch(u_source, ivec2(gl_FragCoord.xy) - ivec2(u_shift), 0).r;
}
