#version 330 core
// Boxes as common/box.vert draws them, each with what passes/cast.frag wants to know of its piece. Switches:
//   PIECES        how many pieces there may be
//   AT_A_LIMIT, ONE_LIMIT   see passes/cast.frag

layout(location = 0) in vec3 a_canvas_px;    // x, y and ENDS times the number of the piece, plus that of an end

const int ENDS = 5;                          // of a piece: its side and its edges

uniform vec2 u_target_size_px;
uniform mat3 u_texels_from_pixel[PIECES];
flat out mat3 v_texel_from_pixel;
#ifdef AT_A_LIMIT
uniform vec4 u_all_limits[PIECES * ENDS];
#ifdef ONE_LIMIT
flat out vec4 v_end;                         // and whether it is an edge rather than the side
#else
flat out vec3 v_side;
flat out vec3 v_edge_1;
flat out vec3 v_edge_2;
flat out vec3 v_edge_3;
flat out vec3 v_edge_4;
#endif
#endif

void main() {
    int number = int(a_canvas_px.z);
    v_texel_from_pixel = u_texels_from_pixel[number / ENDS];
#if defined(ONE_LIMIT)
    v_end = vec4(u_all_limits[number].xyz, number % ENDS == 0 ? 0.0 : 1.0);
#elif defined(AT_A_LIMIT)
    v_side = u_all_limits[number].xyz;
    v_edge_1 = u_all_limits[number + 1].xyz;
    v_edge_2 = u_all_limits[number + 2].xyz;
    v_edge_3 = u_all_limits[number + 3].xyz;
    v_edge_4 = u_all_limits[number + 4].xyz;
#endif
    gl_Position = vec4(a_canvas_px.xy / u_target_size_px * 2.0 - 1.0, 0.0, 1.0);
}
