#version 330 core
// A matte whose texels hold their own alpha and those to the right, below and below right (0 beyond the last).

uniform sampler2D u_source;

out vec4 o_alphas;

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(u_source, 0) - 1;
    ivec2 next = min(here + 1, last);
    vec2 inside = vec2(lessThan(here, last));
    o_alphas = vec4(texelFetch(u_source, here, 0).r,
                    texelFetch(u_source, ivec2(next.x, here.y), 0).r * inside.x,
                    texelFetch(u_source, ivec2(here.x, next.y), 0).r * inside.y,
                    texelFetch(u_source, next, 0).r * inside.x * inside.y);
}
