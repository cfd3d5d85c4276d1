#version 330 core
// Means over squares of texels: the shadow of a coarse band from the one shadow that was cast. Switches:
//   SIDE   texels of the source along a square

uniform sampler2D u_source;
uniform vec2 u_corner;       // first texel of the source that falls into the band's first one
uniform vec2 u_first;        // the band's first texel in the target
uniform vec4 u_known;        // first and last texel of the source: x0, y0, x1, y1; nothing is beyond

out float o_mean;

void main() {
    ivec2 corner = ivec2(u_corner) + (ivec2(gl_FragCoord.xy) - ivec2(u_first)) * SIDE;
    ivec4 known = ivec4(u_known);
    float sum = 0.0;
    // With bounds that are known when compiling no loop has to ask each time whether it goes on.
    for (int y = 0; y < SIDE; ++y) {
        for (int x = 0; x < SIDE; ++x) {
            ivec2 texel = corner + ivec2(x, y);
            ivec2 near = clamp(texel, known.xy, known.zw);
            sum += near == texel ? texelFetch(u_source, near, 0).r : 0.0;
        }
    }
    o_mean = sum / float(SIDE * SIDE);
}
