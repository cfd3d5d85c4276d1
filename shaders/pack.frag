#version 330 core
// Puts the four alphas that meet at a texel's lower right corner into that texel: one fetch is then a bilinear sample.

uniform sampler2D u_source;

out vec4 o_alphas;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 next = min(here + 1, textureSize(u_source, 0) - 1);
    o_alphas = vec4(texelFetch(u_source, here, 0).r, texelFetch(u_source, ivec2(next.x, here.y), 0).r,
                    texelFetch(u_source, ivec2(here.x, next.y), 0).r, texelFetch(u_source, next, 0).r);
}
