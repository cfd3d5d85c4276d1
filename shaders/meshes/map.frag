#version 330 core
// What a light sees of the meshes: how far away it is, and which triangle, counted from 1.

uniform int u_first;

in float v_away;

out vec2 o_seen;

void main() {
    o_seen = vec2(v_away, float(u_first + gl_PrimitiveID + 1));
}
