#version 330 core
// The alpha of a drawing where it lies, and nothing around it.

uniform sampler2D u_matte;             // texels and their neighbours
uniform vec2 u_corner_px;              // where its first texel lies on the target

out float o_alpha;

void main() {
    ivec2 at = ivec2(floor(gl_FragCoord.xy - u_corner_px));
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(u_matte, 0)));
    o_alpha = inside ? texelFetch(u_matte, at, 0).r : 0.0;
}
