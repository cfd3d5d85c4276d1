// The shadow of one card piece at a point of the world. Wants sets/occlusion_cones.glsl. Switches:
//   TRANSLUCENT   alpha casts as it is; else its 0.5 level is the edge
//   LIMITS        how many straight ends the shadow has

uniform sampler2D u_matte;             // texels and their neighbours, with a rim of empty ones
uniform vec4 u_texel_rows[3];          // from the world to matte texels
uniform vec4 u_limits[LIMITS];         // the card's side and the edges of the piece, >= 0 where it casts

vec3 alpha_and_slope(vec2 texel) {
    vec2 place = texel - 0.5;
    vec2 corner = floor(place);
    vec2 f = place - corner;
    // The rim is empty, so clamping to it is the same as finding nothing outside.
    vec4 a = texelFetch(u_matte, clamp(ivec2(corner), ivec2(0), textureSize(u_matte, 0) - 1), 0);
    vec2 rows = mix(a.xz, a.yw, f.x);
    return vec3(mix(rows.x, rows.y, f.y), mix(a.y - a.x, a.w - a.z, f.y), rows.y - rows.x);
}

vec3 projected(vec4 place) {
    return vec3(dot(u_texel_rows[0], place), dot(u_texel_rows[1], place), dot(u_texel_rows[2], place));
}

// The nearest limit decides; where two meet within a cell neither does more than its own part.
float within_limits(vec4 place, mat2x3 cell_world) {
    float nearest = 1e9;
    vec2 direction = vec2(1.0, 0.0);
    for (int index = 0; index < LIMITS; ++index) {
        vec2 slope = u_limits[index].xyz * cell_world;
        float steep = max(length(slope), 1e-30);
        float away = dot(u_limits[index], place) / steep;
        direction = away < nearest ? slope / steep : direction;
        nearest = min(nearest, away);
    }
    return cell_coverage(nearest, direction);
}

// How much of a cell alpha casts. h: its homogeneous place on the matte, step_x and step_y: how far its sides go there.
float alpha_coverage(vec3 h, vec3 step_x, vec3 step_y) {
    if (h.z <= 0.0) {
        return 0.0;
    }
    vec2 texel = h.xy / h.z;
    vec3 alpha = alpha_and_slope(clamp(texel, vec2(-1e6), vec2(1e6)));
#ifdef TRANSLUCENT
    return alpha.x;
#else
    vec2 slope = vec2(dot(alpha.yz, (step_x.xy - texel * step_x.z) / h.z),
                      dot(alpha.yz, (step_y.xy - texel * step_y.z) / h.z));
    return cell_coverage(alpha.x - 0.5, slope);
#endif
}

float cast_coverage(vec4 place, mat2x3 cell_world) {
    vec3 step_x = projected(vec4(cell_world[0], 0.0)), step_y = projected(vec4(cell_world[1], 0.0));
    return alpha_coverage(projected(place), step_x, step_y) * within_limits(place, cell_world);
}
