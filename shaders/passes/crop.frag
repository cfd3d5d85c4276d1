#version 330 core
// The shadow of bands, each from the picture of it that is as fine as the band. Switches:
//   STRIPS   how many there may be

flat in int v_strip;

uniform sampler2D u_source;
uniform vec4 u_shifts[STRIPS];       // from a texel of the strip to that of the source
uniform vec4 u_pictures[STRIPS];     // first and last texel of the source: x0, y0, x1, y1; nothing is beyond

out float o_value;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy) + ivec2(u_shifts[v_strip].xy);
    ivec4 picture = ivec4(u_pictures[v_strip]);
    ivec2 near = clamp(texel, picture.xy, picture.zw);
    o_value = near == texel ? texelFetch(u_source, near, 0).r : 0.0;
}
