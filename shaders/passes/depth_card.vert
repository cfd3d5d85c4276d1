#version 330 core
// A flat piece of the card as the light sees it.

layout(location = 0) in vec3 a_light;      // light space: across, up, away from the light
layout(location = 1) in vec3 a_world_px;

uniform vec4 u_window;                     // centre and half size of what the map shows, in light space
uniform bool u_is_lamp;                    // rays spread from a point; else they are parallel

out vec3 v_world_px;
out float v_away;

void main() {
    v_world_px = a_world_px;
    v_away = a_light.z;
    float w = u_is_lamp ? a_light.z : 1.0;
    gl_Position = vec4((a_light.xy - u_window.xy * w) / u_window.zw, 0.0, w);
}
