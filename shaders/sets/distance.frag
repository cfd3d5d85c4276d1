#version 330 core
// How far along the receivers a place of one of them is from the contact line, px.

uniform vec2 u_origin_px;   // canvas px around which the forms are given, for precision
uniform vec3 u_away;        // their quotient is the distance
uniform vec3 u_lift;

out float o_distance;

void main() {
    vec3 place = vec3(gl_FragCoord.xy - u_origin_px, 1.0);
    float lift = dot(u_lift, place);
    o_distance = lift > 0.0 ? abs(dot(u_away, place)) / lift : 0.0;
}
