#version 330 core
// A solid matte: half-opaque and more casts fully.

uniform sampler2D u_source;

out float o_alpha;

void main() {
    o_alpha = step(0.5, texelFetch(u_source, ivec2(gl_FragCoord.xy), 0).r);
}
