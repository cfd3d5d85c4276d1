#version 330 core
// Means over squares of texels: the shadow of a coarse band from the one shadow that was cast.

uniform sampler2D u_source;
uniform vec2 u_corner;       // first texel of the source that falls into the band's first one
uniform vec2 u_first;        // the band's first texel in the target
uniform vec4 u_known;        // first and last texel of the source: x0, y0, x1, y1; nothing is beyond
uniform int u_side;          // texels of the source along a square

out float o_mean;

void main() {
    ivec2 corner = ivec2(u_corner) + (ivec2(gl_FragCoord.xy) - ivec2(u_first)) * u_side;
    ivec4 known = ivec4(u_known);
    ivec2 low = max(corner, known.xy);
    ivec2 high = min(corner + u_side - 1, known.zw);
    float sum = 0.0;
    for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
            sum += texelFetch(u_source, ivec2(x, y), 0).r;
        }
    }
    o_mean = sum / float(u_side * u_side);
}
