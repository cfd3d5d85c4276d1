// A picture whose texels do not fall on pixels: what lies between four of them, mean over cells where it shrinks.

uniform mat3 u_texel_from_pixel;       // texel centres at +0.5
uniform int u_cells;                   // into so many cells a pixel is split, each way

// Colour times alpha, and alpha; of a texture of one channel that is its alpha. Nothing lies beyond the rim.
vec4 weighted_texel(sampler2D source, ivec2 at) {
    bool inside = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, textureSize(source, 0)));
    if (!inside) {
        return vec4(0.0);
    }
    vec4 texel = texelFetch(source, at, 0);
#ifdef ONE_CHANNEL
    return vec4(texel.r);
#else
    return vec4(texel.rgb * texel.a, texel.a);
#endif
}

vec4 between_texels(sampler2D source, vec2 texel) {
    vec2 place = texel - 0.5;
    ivec2 corner = ivec2(floor(place));
    vec2 f = place - vec2(corner);
    vec4 above = mix(weighted_texel(source, corner), weighted_texel(source, corner + ivec2(1, 0)), f.x);
    vec4 below = mix(weighted_texel(source, corner + ivec2(0, 1)), weighted_texel(source, corner + ivec2(1, 1)), f.x);
    return mix(above, below, f.y);
}

// What is seen in this pixel: straight colour and alpha.
vec4 moved_texel(sampler2D source) {
    vec4 sum = vec4(0.0);
    for (int y = 0; y < u_cells; ++y) {
        for (int x = 0; x < u_cells; ++x) {
            vec2 inside = (vec2(float(x), float(y)) + 0.5) / float(u_cells) - 0.5;
            sum += between_texels(source, (u_texel_from_pixel * vec3(gl_FragCoord.xy + inside, 1.0)).xy);
        }
    }
    sum /= float(u_cells * u_cells);
    return sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a) : vec4(0.0);
}
