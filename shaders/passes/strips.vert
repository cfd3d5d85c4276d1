#version 330 core
// Boxes as common/box.vert draws them, each with the number of the strip that it belongs to.

layout(location = 0) in vec3 a_target_px;    // x, y and the strip

uniform vec2 u_target_size_px;
flat out int v_strip;

void main() {
    v_strip = int(a_target_px.z);
    gl_Position = vec4(a_target_px.xy / u_target_size_px * 2.0 - 1.0, 0.0, 1.0);
}
