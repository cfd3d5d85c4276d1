#version 330 core
// Lays one source over what is under it and writes the whole result: straight alpha, sRGB-coded as compositing is done.
// The source is a picture (character, background) or one colour with a covered part of its own (shadow); with MOST_TAKEN
// it is what united shadows take of each part of white, and their covered part (common/shade.frag). Switch:
//   MOVED   the picture's texels do not fall on pixels

#include "common/look.glsl"

uniform sampler2D u_under;          // copy of the target's pixels
uniform sampler2D u_source;         // RGBA picture, or covered part in red
#ifdef MOVED
#include "common/between_texels.glsl"
#else
uniform vec2 u_source_corner_px;  // canvas px of the source's first texel
#endif
uniform bool u_is_picture;
uniform vec3 u_color;
uniform float u_opacity;
uniform bool u_multiply;

out vec4 o_color;

#ifdef OUTLINED
uniform int u_line_px;              // half the line's width

// Where the outline, at which half is covered, passes within the line's width. A blurred edge is taken as a steep one.
float line_at(ivec2 here) {
    ivec2 last = textureSize(u_source, 0) - 1;
    float least = 1.0, most = 0.0;
    for (int y = -u_line_px; y <= u_line_px; y++) {
        for (int x = -u_line_px; x <= u_line_px; x++) {
            if (x * x + y * y <= u_line_px * u_line_px) {
                float part = texelFetch(u_source, clamp(here + ivec2(x, y), ivec2(0), last), 0).r;
                part = clamp((part - 0.5) * 3.0 + 0.5, 0.0, 1.0);
                least = min(least, part);
                most = max(most, part);
            }
        }
    }
    return most - least;
}
#endif

void main() {
    ivec2 here = ivec2(gl_FragCoord.xy);
    vec4 under = texelFetch(u_under, here, 0);
#ifdef MOVED
    vec4 texel = moved_texel(u_source);
#else
    vec4 texel = texelFetch(u_source, here - ivec2(u_source_corner_px), 0);
#endif
    vec4 source = u_is_picture ? texel : vec4(color_at(gl_FragCoord.xy, u_color), texel.r * opacity_at(gl_FragCoord.xy, u_opacity));
#ifdef MOST_TAKEN
    source = vec4(texel.a > 0.0 ? 1.0 - texel.rgb / texel.a : vec3(0.0), texel.a * u_opacity);
#endif
#ifdef OUTLINED
    source = vec4(u_color, line_at(here));
#endif
#ifdef CONTRASTING
    // A light grey on dark pictures and a dark one on light ones.
    float light = dot(under.rgb, vec3(0.3, 0.59, 0.11)) * under.a + 1.0 - under.a;
    source.rgb = vec3(mix(0.88, 0.12, smoothstep(0.62, 0.7, light)));
#endif
    vec3 mixed = u_multiply ? source.rgb * under.rgb : source.rgb;
    float alpha = source.a + under.a * (1.0 - source.a);
    vec3 sum = source.a * (1.0 - under.a) * source.rgb + source.a * under.a * mixed
             + (1.0 - source.a) * under.a * under.rgb;
    o_color = alpha > 0.0 ? vec4(sum / alpha, alpha) : vec4(0.0);
}
