#version 330 core
// The part of each pixel in which the meshes do not hide a face. With ROUND the face is a ball or the side of a drum.

#include "edge.glsl"
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
    int count = middle == 0 ? 0 : several ? u_side * u_side : 1;
    float hidden = 0.0;
    for (int index = 0; index < count; ++index) {
        int triangle = several ? sample_at(at, index) : middle;
        if (triangle > 0) {
            vec4 plane = plane_of(triangle);
            vec2 here = pixel + (several ? sample_offset(index, u_side) : vec2(0.0));
#ifdef ROUND
            hidden += before_face(plane, here) > -TIE_PX ? 1.0 : 0.0;
#else
            // As mesh_shade.frag tells what is seen of the mesh, so that both add up.
            vec2 slope = u_face.xyz * pixel_on(plane, here) / (several ? float(u_side) : 1.0);
            float value = before_face(plane, here) + TIE_PX;
            float steep = max(length(slope), 1e-30);
            hidden += cell_coverage(value / steep, slope / steep);
#endif
        }
    }
    o_past = 1.0 - hidden / float(max(count, 1));
}
