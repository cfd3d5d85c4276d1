#version 330 core
// The alpha of a drawing where it lies, and nothing around it. Switch:
//   MOVED   the drawing's texels do not fall on pixels; wants ONE_CHANNEL as well

uniform sampler2D u_matte;             // texels and their neighbours; a texel's own alpha is red

out float o_alpha;

#ifdef MOVED
#include "common/between_texels.glsl"

void main() {
    o_alpha = moved_texel(u_matte).a;
}
#else
uniform vec2 u_corner_px;              // where its first texel lies on the target

void main() {
    ivec2 at = ivec2(floor(gl_FragCoord.xy - u_corner_px));
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(u_matte, 0)));
    o_alpha = inside ? texelFetch(u_matte, at, 0).r : 0.0;
}
#endif
