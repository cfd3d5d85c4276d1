#version 330 core
// The inside of a shadow, where every pixel is wholly covered.

#include "common/grazing.glsl"

uniform vec2 u_origin_px;

out float o_coverage;

void main() {
    o_coverage = grazing_strength(gl_FragCoord.xy - u_origin_px);
}
