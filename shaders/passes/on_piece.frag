#version 330 core
// What of a picture lies on one piece of a card: each pixel belongs where its centre lies. Switches:
//   LIMITS   how many edges the piece has

uniform sampler2D u_source;            // of the target's size
uniform vec4 u_limits[LIMITS];         // signed distances in px of the target (x, y, 1), >= 0 within the piece

out float o_alpha;

void main() {
    bool inside = true;
    for (int index = 0; index < LIMITS; ++index) {
        inside = inside && dot(u_limits[index].xyz, vec3(gl_FragCoord.xy, 1.0)) >= 0.0;
    }
    o_alpha = inside ? texelFetch(u_source, ivec2(gl_FragCoord.xy), 0).r : 0.0;
}
