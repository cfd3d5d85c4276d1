#version 330 core
// Lines of meshes as thin boxes on the canvas, wide enough for their soft rims.

layout(location = 0) in vec2 a_canvas_px;
layout(location = 1) in vec2 a_across_px;  // how far beside the line, and how far beyond its end
layout(location = 2) in float a_nearness;  // of the line: 1 / (1 + length of the ray), or with parallel rays that length

uniform vec2 u_target_size_px;

out vec2 v_across_px;
out float v_nearness;

void main() {
    v_across_px = a_across_px;
    v_nearness = a_nearness;
    gl_Position = vec4(a_canvas_px / u_target_size_px * 2.0 - 1.0, 0.0, 1.0);
}
