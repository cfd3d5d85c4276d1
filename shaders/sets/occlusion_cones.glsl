// What bodies hide from the eye and take from the light at a point of the world: cones of planes and a quadric.
// A cell is told by how far its own sides in x and y go over the world. Wants common/edge.glsl.

uniform sampler2D u_table;             // rows of 256: cones of bodies as (first plane, behind the last, quadric or -1,
                                       // flags), where plane and quadric are places in the table; then those
uniform int u_region_count;

const int LAST = 1, OVERLAPS = 2, LIGHT = 8;

vec4 row_of(int index) {
    return texelFetch(u_table, ivec2(index & 255, index >> 8), 0);
}

float edge_of(float value, vec2 slope) {
    float steep = max(length(slope), 1e-30);
    return cell_coverage(value / steep, slope / steep);
}

float region_coverage(vec4 region, vec4 place, mat2x3 cell_world) {
    float covered = 1.0;
    for (int index = int(region.x); index < int(region.y); ++index) {
        vec4 plane = row_of(index);
        covered *= edge_of(dot(plane, place), plane.xyz * cell_world);
    }
    if (region.z >= 0.0) {
        int row = int(region.z);
        vec4 bent = vec4(dot(row_of(row), place), dot(row_of(row + 1), place),
                         dot(row_of(row + 2), place), dot(row_of(row + 3), place));
        covered *= edge_of(dot(bent, place), 2.0 * bent.xyz * cell_world);
    }
    return covered;
}

// Seen part and lit part.
vec2 seen_and_lit(vec4 place, mat2x3 cell_world) {
    vec2 left = vec2(1.0);
    float taken = 0.0;
    for (int index = 0; index < u_region_count; ++index) {
        vec4 region = row_of(index);
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
