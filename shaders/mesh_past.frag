#version 330 core
// In which of the 4 by 4 parts of each pixel the meshes do not hide a face, a bit for each. With ROUND the face is a ball or the side of a drum.

#include "mesh_surface.glsl"

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
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uint record = texelFetch(u_pixels, at, 0).r;
    bool several = (record & SEVERAL) != 0u;
    int middle = int(record & ~SEVERAL);
    int count = middle == 0 ? 0 : 16;
    int bits = 0xFFFF;
    vec4 plane = plane_of(max(middle, 1));
    for (int index = 0; index < count; ++index) {
        int triangle = middle;
        if (several) {
            ivec2 part = ivec2(index % 4, index / 4) * u_side / 4;
            triangle = sample_at(at, part.y * u_side + part.x);
        }
        vec4 own = several ? plane_of(max(triangle, 1)) : plane;
        // As mesh_shade.frag tells what is seen of the mesh, so that both add up.
        if (triangle > 0 && before_face(own, pixel + sample_offset(index, 4)) > -TIE_PX) {
            bits &= ~(1 << index);
        }
    }
    o_past = float(bits) / 65535.0;
}
