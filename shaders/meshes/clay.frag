#version 330 core
// Meshes as grey clay, lit from both sides by a lamp over the viewer's left shoulder.

#include "meshes/surface.glsl"

uniform int u_wanted;                  // which of the flags of u_asked what is drawn has
uniform int u_asked;
out vec4 o_color;

const vec3 LAMP = vec3(-0.43, -0.65, 0.63);

float grey_of(vec4 plane, vec2 pixel) {
    vec3 to_eye = normalize(-ray_along(ray_start(pixel)));
    vec3 normal = plane.xyz * (dot(plane.xyz, to_eye) < 0.0 ? -1.0 : 1.0);
    return 0.30 + 0.42 * max(dot(normal, LAMP), 0.0) + 0.14 * dot(normal, to_eye);
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    uvec4 record = texelFetch(u_pixels, ivec2(gl_FragCoord.xy), 0);
    vec2 sum = vec2(0.0);
    for (int part = 0; part < PARTS; ++part) {
        int triangle = part_triangle(record, part);
        if (triangle > 0 && (int(triangle_part(triangle, 0).w) & u_asked) == u_wanted) {
            float weight = count_of(part_mask(record, part)) / 16.0;
            sum += weight * vec2(grey_of(plane_of(triangle), pixel), 1.0);
        }
    }
    o_color = vec4(vec3(sum.x / max(sum.y, 1e-6)), sum.y);
}
