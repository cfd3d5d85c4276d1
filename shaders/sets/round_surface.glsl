// Where the view ray through a pixel meets a ball or the side of an endless drum, around the middle of the body.

uniform vec2 u_origin_px;              // canvas px around which pixels are counted
uniform vec3 u_origin_world;           // the same point of the drawing's plane, around the middle of the body
uniform vec4 u_eye;                    // homogeneous, around the middle of the body
uniform mat3 u_across;                 // the body's surface is where Y across Y = radius²
uniform float u_radius;

vec3 surface_at(vec2 pixel) {
    vec3 start = u_origin_world + vec3(pixel, 0.0);
    vec3 along = u_eye.w == 0.0 ? -u_eye.xyz : start - u_eye.xyz;
    vec3 bent = u_across * along;
    float a = dot(along, bent);
    // From the point of the ray nearest to the axis, so that no large numbers cancel.
    start -= along * (dot(start, bent) / a);
    float inside = u_radius * u_radius - dot(start, u_across * start);
    return start - along * sqrt(max(inside, 0.0) / a);
}
