#version 330 core
// Boxes given in canvas px (y down). Row 0 of every target is the top row, so nothing is flipped on the way.

layout(location = 0) in vec2 a_canvas_px;

uniform vec2 u_target_size_px;

void main() {
    gl_Position = vec4(a_canvas_px / u_target_size_px * 2.0 - 1.0, 0.0, 1.0);
}
