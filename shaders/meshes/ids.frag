#version 330 core
// Which triangle is seen, counted from 1.

uniform int u_first;                   // the number of the first one drawn

out uint o_triangle;

void main() {
    o_triangle = uint(u_first + gl_PrimitiveID + 1);
}
