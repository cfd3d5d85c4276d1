// An outline that is moved outward, and an edge wider than a pixel, from the value and the slope of the blurred shadow.
// Across a straight edge a Gaussian's blur is the normal distribution, so its inverse is the distance to the edge in
// standard deviations; divided by its own slope it is that distance in px, near the edge of any shape.

uniform float u_softness_px;
uniform float u_penumbra;          // px of width with every px of v away from the contact line
uniform float u_grow_px;
uniform float u_level_deviations;  // the inverse normal distribution of the level
uniform vec4 u_blurred_from_ground;   // rows of the matrix from the ground's u and v to those of the blurred shadow

const float RAMP = 0.75;           // of the width, on either side

// Inverse of the normal distribution, by Winitzki's inverse of the error function; right within 0.2 %.
float deviations(float part) {
    float x = 2.0 * clamp(part, 1e-5, 1.0 - 1e-5) - 1.0;
    float l = log(1.0 - x * x);
    float half_sum = 4.3307468 + 0.5 * l;
    return 1.4142136 * sign(x) * sqrt(max(sqrt(half_sum * half_sum - l / 0.147) - half_sum, 0.0));
}

// rise: slope of the value in u and v; direction, steep: its slope on the canvas, as a unit vector and its length.
float wide_edge(float value, vec2 rise, vec2 direction, float steep, float v) {
    float away = deviations(value);
    float density = exp(-0.5 * away * away) / 2.5066283;
    float on_ground = max(length(rise * mat2(u_blurred_from_ground.xz, u_blurred_from_ground.yw)), 1e-9);
    float apart_px = (away - u_level_deviations) * density / on_ground + u_grow_px;
    float ground_per_pixel = max(steep / on_ground, 1e-6);
    float width_px = u_softness_px + u_penumbra * abs(v);
    float crisp = cell_coverage(apart_px / ground_per_pixel, direction);
    float soft = smoothstep(-RAMP * width_px - 1e-6, RAMP * width_px + 1e-6, apart_px);
    return mix(crisp, soft, smoothstep(1.0, 2.0, width_px / ground_per_pixel));
}
