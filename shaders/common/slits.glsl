// Gaps in a shadow on water: rows of long lenses along the crests of waves (kagezou/geometry/slits.py has the words).

uniform mat3 u_slits_from_plane;       // (u, v, 1) of the blurred shadow -> along the crests, where they go, |v| in px
uniform vec4 u_slits;                  // share, spacing px, growth, the distance up to which there are none, px
uniform vec2 u_slits_moved;            // how far rows have gone as a part of the spacing; by which part lengths differ
uniform vec3 u_slit_rows;              // what is added to a row's number; after how many they come again; the seed

const float LENGTH_SPACINGS = 26.0;
const float LEAST_WIDTH = 0.3;
const float MOST_WIDTH = 0.6;
const float WIDER = 0.35;
const float BOW = 0.6;
const float SWAY = 0.12;
const vec2 SWAY_SPACINGS = vec2(6.1, 8.7);
const float BREATH = 0.2;
const float BREATH_SPACINGS = 7.3;

uint mixed(uint state) {
    state += 0x9E3779B9u;
    state = (state ^ (state >> 16)) * 0x7FEB352Du;
    state = (state ^ (state >> 15)) * 0x846CA68Bu;
    return state ^ (state >> 16);
}

float chance(uint place, uint which) {
    return float(mixed(place ^ which) >> 8) / 16777216.0;
}

// The part of a pixel that lies within a gap; step_plane is the change of the place with the pixel.
float open_part(vec2 plane, mat2 step_plane) {
    vec3 ground = u_slits_from_plane * vec3(plane, 1.0);
    float spacing = u_slits.y;
    float beyond = abs(ground.z) - u_slits.w;
    if (beyond <= 0.0) {
        return 0.0;
    }
    float sway = 6.2831853 * dot(ground.xy / spacing, 1.0 / SWAY_SPACINGS);
    ground.y += SWAY * spacing * sin(sway);
    vec2 swaying = 6.2831853 * SWAY * cos(sway) / SWAY_SPACINGS;
    float length_px = LENGTH_SPACINGS * spacing;
    float row = floor(ground.y / spacing - u_slits_moved.x);
    float middle = (row + 0.5 + u_slits_moved.x) * spacing;
    uint number = uint(int(row) + int(u_slit_rows.x)) % uint(u_slit_rows.y);
    uint of_row = mixed(uint(u_slit_rows.z) ^ number);
    float along = ground.x + length_px * chance(mixed(of_row), 0u);
    float part = floor(along / length_px);
    uint of_part = mixed(of_row ^ uint(int(part)));
    float half_px = 0.5 * length_px * u_slits.x * (1.0 + u_slits_moved.y * (2.0 * chance(of_part, 1u) - 1.0));
    float start = half_px + (length_px - 2.0 * half_px) * chance(of_part, 2u);
    float place = (along - part * length_px - start) / half_px;
    float thin = 1.0 - place * place;
    if (thin <= 0.0) {
        return 0.0;
    }
    float risen = smoothstep(0.0, 1.0, beyond / spacing);
    float width = 0.5 * risen * (LEAST_WIDTH * spacing + u_slits.z * beyond);
    width *= 1.0 + WIDER * (2.0 * chance(of_part, 3u) - 1.0);
    float breath = chance(of_part, 6u) + middle / (BREATH_SPACINGS * spacing);
    width *= 1.0 - BREATH + BREATH * cos(6.2831853 * fract(breath));
    width = min(width, 0.5 * MOST_WIDTH * spacing);
    float bow = BOW * (2.0 * chance(of_part, 4u) - 1.0);
    float shift = (0.5 * spacing - width * (1.0 + abs(bow))) * (2.0 * chance(of_part, 5u) - 1.0);
    float across = ground.y - middle - shift - bow * width * thin;
    // The two edges change with the place along the gap as the parabolas do.
    float steep = -2.0 * place * width / half_px;
    mat2 step_ground = mat2(1.0, swaying.x, 0.0, 1.0 + swaying.y) * mat2(u_slits_from_plane) * step_plane;
    vec2 upper = vec2(steep * (1.0 + bow), -1.0) * step_ground;
    vec2 lower = vec2(steep * (1.0 - bow), 1.0) * step_ground;
    float upper_px = max(length(upper), 1e-7);
    float lower_px = max(length(lower), 1e-7);
    float within = cell_coverage((width * thin - across) / upper_px, upper / upper_px)
                 + cell_coverage((width * thin + across) / lower_px, lower / lower_px) - 1.0;
    return max(within, 0.0);
}
