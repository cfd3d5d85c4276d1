#version 330 core
// A mesh as the camera or a light sees it. With AWAY also how far it is from the light.

layout(location = 0) in vec3 a_place;  // world px around the origin of the meshes

uniform vec4 u_clip_rows[4];           // from there to clip space

#ifdef AWAY
uniform vec4 u_away;

out float v_away;
#endif

void main() {
    vec4 place = vec4(a_place, 1.0);
    gl_Position = vec4(dot(u_clip_rows[0], place), dot(u_clip_rows[1], place),
                       dot(u_clip_rows[2], place), dot(u_clip_rows[3], place));
#ifdef AWAY
    v_away = dot(u_away, place);
#endif
}
