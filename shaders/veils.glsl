// What bodies hide from the eye and take from the light at a point of the world: cones of planes and a quadric.
// A cell is told by how far its own sides in x and y go over the world. Wants edge.glsl.

uniform vec4 u_regions[MAX_REGIONS];   // cones of bodies: first plane, behind the last, quadric or -1, flags
uniform vec4 u_planes[MAX_LINES];
uniform vec4 u_quadrics[4 * MAX_CONICS];
uniform int u_region_count;

const int LAST = 1, OVERLAPS = 2, LIGHT = 8;

float edge_of(float value, vec2 slope) {
    float steep = max(length(slope), 1e-30);
    return cell_coverage(value / steep, slope / steep);
}

float region_coverage(vec4 region, vec4 place, mat2x3 cell_world) {
    float covered = 1.0;
    for (int index = int(region.x); index < int(region.y); ++index) {
        vec4 plane = u_planes[index];
        covered *= edge_of(dot(plane, place), plane.xyz * cell_world);
    }
    if (region.z >= 0.0) {
        int row = 4 * int(region.z);
        vec4 bent = vec4(dot(u_quadrics[row], place), dot(u_quadrics[row + 1], place),
                         dot(u_quadrics[row + 2], place), dot(u_quadrics[row + 3], place));
        covered *= edge_of(dot(bent, place), 2.0 * bent.xyz * cell_world);
    }
    return covered;
}

// Seen part and lit part.
vec2 seen_and_lit(vec4 place, mat2x3 cell_world) {
    vec2 left = vec2(1.0);
    float taken = 0.0;
    for (int index = 0; index < u_region_count; ++index) {
        vec4 region = u_regions[index];
        int flags = int(region.w);
        float covered = region_coverage(region, place, cell_world);
        taken = (flags & OVERLAPS) != 0 ? max(taken, covered) : min(taken + covered, 1.0);
        if ((flags & LAST) != 0) {
            left *= (flags & LIGHT) != 0 ? vec2(1.0, 1.0 - taken) : vec2(1.0 - taken, 1.0);
            taken = 0.0;
        }
    }
    return left;
}
