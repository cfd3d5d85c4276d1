// Seams at which a receiver passes over into what another chart has of the shadow.

const int MAX_JOINS = 16;

uniform int u_join_count;
uniform vec4 u_seams[MAX_JOINS];        // the ends; the receiver lies to the left of the way from the first to the second
uniform vec4 u_join_bands[MAX_JOINS];   // the other chart's first band, behind its last; reach in px; weight at the seam
uniform vec4 u_join_turns[MAX_JOINS];   // rows of the map from a place to that of the other chart ...
uniform vec4 u_join_shifts[MAX_JOINS];  // ... and its shift

const float NEARLY_ALL = 1.0001;

mat2 join_turn(int index) {
    vec4 rows = u_join_turns[index];
    return mat2(rows.xz, rows.yw);
}

// Full at the seam, nothing behind it and far from it; around its ends it goes over from the one to the other.
// A pixel that the seam crosses may have its middle a pixel behind it.
float join_weight(int index, vec2 place, float pixel_px) {
    vec4 seam = u_seams[index];
    vec2 run = seam.zw - seam.xy;
    float whole = max(length(run), 1e-6);
    vec2 away = place - seam.xy;
    float along = dot(away, run) / whole;
    float before = (run.x * away.y - run.y * away.x) / whole;
    float beyond = max(max(-along, along - whole), 0.0);
    float side = smoothstep(-1.0, 1.0, clamp((before + pixel_px) / max(beyond, 1e-4), -1.0, 1.0));
    vec4 bands = u_join_bands[index];
    return bands.w * side * (1.0 - smoothstep(0.4 * bands.z, bands.z, length(vec2(before, beyond))));
}

// How much a join of some weight counts beside others: the whole at its own seam.
float join_share(float weight) {
    return weight / (NEARLY_ALL - weight);
}
