#version 330 core
// One direction of a small Gaussian over a matte: rounds the stairs of paint data that has no anti-aliasing.

uniform sampler2D u_source;
uniform vec2 u_axis;        // (1, 0) or (0, 1)
uniform float u_sigma_px;

out float o_alpha;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(u_source, 0) - 1;
    int reach = int(ceil(3.0 * u_sigma_px));
    float sum = 0.0;
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float weight = exp(-0.5 * float(i * i) / (u_sigma_px * u_sigma_px));
        sum += weight * texelFetch(u_source, clamp(here + ivec2(u_axis) * i, ivec2(0), last), 0).r;
        weights += weight;
    }
    o_alpha = sum / weights;
}
