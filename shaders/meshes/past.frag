#version 330 core
// In which samples of each pixel the meshes do not hide a face, a bit for each. With ROUND the face is a ball or the side of a drum.

#include "meshes/surface.glsl"

#ifdef ROUND
uniform vec3 u_centre;
uniform mat3 u_across;                 // the surface is where Y across Y = radius² around the centre
uniform float u_radius;

// How much nearer to the eye than the face a triangle's plane is met.
float before_face(vec4 plane, vec2 pixel) {
    vec3 start = ray_start(pixel);
    vec3 along = ray_along(start);
    vec3 local = start - u_centre;
    vec3 bent = u_across * along;
    float a = dot(along, bent);
    float nearest = -dot(local, bent) / a;
    local += along * nearest;
    float inside = u_radius * u_radius - dot(local, u_across * local);
    return (nearest - sqrt(max(inside, 0.0) / a) - reach_of(plane, start, along)) * length(along);
}
#else
uniform vec4 u_face;                   // positive on the side of the eye

float before_face(vec4 plane, vec2 pixel) {
    return dot(u_face, vec4(met(plane, pixel), 1.0));
}
#endif

out float o_past;

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uvec4 record = texelFetch(u_pixels, ivec2(gl_FragCoord.xy), 0);
    int bits = WHOLE;
    for (int part = 0; part < PARTS; ++part) {
        int triangle = part_triangle(record, part);
        int mask = part_mask(record, part);
        vec4 plane = plane_of(max(triangle, 1));
        int count = triangle > 0 ? FINE * FINE : 0;
        for (int index = 0; index < count; ++index) {
            int bit = 1 << index;
            // As meshes/shade.frag tells what is seen of the mesh, so that both add up.
            if ((mask & bit) != 0 && before_face(plane, pixel + sample_offset(index)) > -TIE_PX) {
                bits &= ~bit;
            }
        }
    }
    o_past = float(bits) / 65535.0;
}
