#version 330 core
// Stores how far the card is from the light wherever the drawing is opaque: a shadow map, literally.

uniform sampler2D u_matte;
uniform mat3 u_texel_from_canvas;
uniform vec3 u_eye;                        // eye x, y and 1 / distance (0 for the orthographic camera)
uniform vec2 u_range;                      // nearest and farthest distance kept

in vec3 v_world_px;
in float v_away;

void main() {
    vec2 canvas = (v_world_px.xy - u_eye.z * u_eye.xy * v_world_px.z) / (1.0 - u_eye.z * v_world_px.z);
    vec2 size = vec2(textureSize(u_matte, 0));
    vec2 place = (u_texel_from_canvas * vec3(canvas, 1.0)).xy / size;
    bool inside = all(greaterThanEqual(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
    if (!inside || texture(u_matte, place).r < 0.5) {
        discard;
    }
    gl_FragDepth = (v_away - u_range.x) / (u_range.y - u_range.x);
}
