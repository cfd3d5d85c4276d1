#version 330 core
// The inside of a shadow, where every pixel is wholly covered. Switches:
//   SLITS   but for the gaps that waves leave open (common/slits.glsl)
//   LAMP_IS_LOW   see common/grazing.glsl

#include "common/grazing.glsl"
#ifdef SLITS
#include "common/edge.glsl"
#include "common/slits.glsl"

uniform mat3 u_plane_from_pixel;       // canvas px - origin -> u along the contact line, v away from it
#endif

uniform vec2 u_origin_px;

out float o_coverage;

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    o_coverage = grazing_strength(pixel);
#ifdef SLITS
    vec3 h = u_plane_from_pixel * vec3(pixel, 1.0);
    vec2 plane = h.xy / h.z;
    mat2 step_plane = mat2(u_plane_from_pixel[0].xy - plane * u_plane_from_pixel[0].z,
                           u_plane_from_pixel[1].xy - plane * u_plane_from_pixel[1].z) / h.z;
    o_coverage *= 1.0 - open_part(plane, step_plane);
#endif
}
