#version 330 core
// Places the finished picture in a window: row 0 of the picture is its top, row 0 of a window its bottom, of a copy
// of the window its top.

uniform sampler2D u_picture;
uniform vec2 u_rows;  // window px from the top = rows.x + rows.y * row of the framebuffer
uniform vec3 u_canvas_from_window;  // scale, then shift: canvas px = window px (y down) * x + yz
uniform vec2 u_canvas_size_px;
uniform vec3 u_surround;

out vec4 o_color;

void main() {
    vec2 window = vec2(gl_FragCoord.x, u_rows.x + u_rows.y * gl_FragCoord.y);
    vec2 canvas = window * u_canvas_from_window.x + u_canvas_from_window.yz;
    bool inside = all(greaterThanEqual(canvas, vec2(0.0))) && all(lessThan(canvas, u_canvas_size_px));
    vec4 picture = texture(u_picture, canvas / u_canvas_size_px);
    o_color = vec4(inside ? mix(u_surround, picture.rgb, picture.a) : u_surround, 1.0);
}
