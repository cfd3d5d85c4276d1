// What is seen of the meshes: the triangles of a pixel, and where the view ray meets the plane of one.
// All places are world px around one origin near the meshes.

#include "meshes/triangles.glsl"
#include "common/samples.glsl"

uniform usampler2D u_pixels;           // up to three triangles of a pixel, counted from 1: see part_triangle, part_mask
uniform vec2 u_origin_px;              // canvas px around which pixels are counted
uniform vec3 u_origin_world;           // the same point of the drawing's plane
uniform vec4 u_eye;                    // homogeneous

const float TIE_PX = 0.02;             // a mesh that lies this near behind a face is before it
vec4 plane_of(int triangle) {
    return triangle_part(triangle, 3);
}

// The samples of a pixel that lie in one plane are a part, told by the triangle of the first of them.
const int PARTS = 3;

int part_triangle(uvec4 record, int part) {
    return int(record[part] & 0xFFFFFFu);
}

// Which samples a part holds, a bit for each.
int part_mask(uvec4 record, int part) {
    return int(record[part] >> 24) | int((record.w >> uint(8 * part)) & 0xFFu) << 8;
}

// In which part a sample lies, 0 to 2, or 3 for none.
int part_with(uvec4 record, int bit) {
    return (part_mask(record, 0) & bit) != 0 ? 0 : (part_mask(record, 1) & bit) != 0 ? 1
         : (part_mask(record, 2) & bit) != 0 ? 2 : PARTS;
}

// The first of some samples.
int first_of(int mask) {
    return int(count_of((mask & -mask) - 1));
}

vec3 ray_start(vec2 pixel) {
    return u_origin_world + vec3(pixel, 0.0);
}

vec3 ray_along(vec3 start) {
    return u_eye.w == 0.0 ? -u_eye.xyz : start - u_eye.xyz;
}

// How far along its ray a plane is met, in lengths of that.
float reach_of(vec4 plane, vec3 start, vec3 along) {
    float falling = dot(plane.xyz, along);
    return -(dot(plane.xyz, start) + plane.w) / (abs(falling) < 1e-9 ? 1e-9 : falling);
}

vec3 met(vec4 plane, vec2 pixel) {
    vec3 start = ray_start(pixel);
    vec3 along = ray_along(start);
    return start + along * reach_of(plane, start, along);
}

// The plane's homogeneous places around a pixel, which are linear in canvas px: how far one px goes in x, in y, and the
// place at the pixel itself, whose w is 1.
mat3x4 places_on(vec4 plane, vec2 pixel) {
    vec3 start = ray_start(pixel);
    vec3 along = ray_along(start);
    float falling = dot(plane.xyz, along);
    falling = abs(falling) < 1e-9 ? 1e-9 : falling;
    float above = dot(plane.xyz, start) + plane.w;
    float own = falling - u_eye.w * above;
    return mat3x4((vec4(own, 0.0, 0.0, 0.0) + u_eye * plane.x) / falling,
                  (vec4(0.0, own, 0.0, 0.0) + u_eye * plane.y) / falling,
                  vec4(start - along * (above / falling), 1.0));
}

// How far one px in x and in y goes over the world where places go on so.
mat2x3 pixel_over(mat3x4 places) {
    return mat2x3(places[0].xyz - places[2].xyz * places[0].w, places[1].xyz - places[2].xyz * places[1].w);
}

// How far one px in x and in y goes over the plane.
mat2x3 pixel_on(vec4 plane, vec2 pixel) {
    return pixel_over(places_on(plane, pixel));
}
