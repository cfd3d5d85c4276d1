#version 330 core
// A part of a picture laid into another one: what is within the first polygon and within none of the others.
// What lies on both sides of a hinge is alike, and what is laid here is blurred, so no edge is smoothed.

uniform sampler2D u_source;
uniform vec4 u_sides[MAX_SIDES];         // (a, b, c, -), >= 0 inside
uniform vec4 u_polygons[MAX_POLYGONS];   // its first side, the one behind its last
uniform int u_polygon_count;

out float o_value;

bool is_within(vec4 polygon, vec2 place) {
    for (int index = int(polygon.x); index < int(polygon.y); ++index) {
        if (dot(u_sides[index].xyz, vec3(place, 1.0)) < 0.0) {
            return false;
        }
    }
    return true;
}

void main() {
    vec2 place = gl_FragCoord.xy;
    if (!is_within(u_polygons[0], place)) {
        discard;
    }
    for (int index = 1; index < u_polygon_count; ++index) {
        if (is_within(u_polygons[index], place)) {
            discard;
        }
    }
    o_value = texelFetch(u_source, ivec2(place), 0).r;
}
