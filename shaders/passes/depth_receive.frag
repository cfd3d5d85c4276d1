#version 330 core
// Looks each point of the receiver up in the shadow map: in shadow where the map holds something nearer the light.

uniform sampler2D u_map;
uniform mat3 u_light_from_canvas;          // canvas px -> light space, times the receiver's w
uniform vec3 u_receiver_w;
uniform vec4 u_window;
uniform bool u_is_lamp;
uniform vec2 u_range;

out float o_coverage;

void main() {
    vec3 place = vec3(gl_FragCoord.xy, 1.0);
    float w = dot(u_receiver_w, place);
    vec3 light = u_light_from_canvas * place / w;
    vec2 seen = u_is_lamp ? light.xy / light.z : light.xy;
    vec2 map = (seen - u_window.xy) / u_window.zw * 0.5 + 0.5;
    bool inside = w > 0.0 && light.z > 0.0
               && all(greaterThanEqual(map, vec2(0.0))) && all(lessThan(map, vec2(1.0)));
    float nearest = texture(u_map, map).r * (u_range.y - u_range.x) + u_range.x;
    o_coverage = inside && nearest < u_range.y && nearest < light.z ? 1.0 : 0.0;
}
