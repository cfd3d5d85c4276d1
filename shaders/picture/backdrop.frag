#version 330 core
// What shows where nothing is drawn: two tones in squares of the canvas.

uniform vec4 u_tone;
uniform vec4 u_other_tone;
uniform int u_square_px;

out vec4 o_color;

void main() {
    ivec2 square = ivec2(gl_FragCoord.xy) / u_square_px;
    o_color = ((square.x + square.y) & 1) == 0 ? u_tone : u_other_tone;
}
