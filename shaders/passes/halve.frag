#version 330 core
// A picture half as fine along one axis. Weights of 1, 3, 3, 1 overlap, so that where an edge lies between two texels
// makes it neither sharper nor softer. Switches:
//   ALONG_V   along v, otherwise along u

uniform sampler2D u_source;
uniform vec2 u_corner;       // where the source's picture begins, and ...
uniform vec2 u_first;        // ... that of the target
uniform vec2 u_known;        // first and last texel along the axis, from the source's corner; nothing is beyond

out float o_mean;

#ifdef ALONG_V
const int AXIS = 1;
#else
const int AXIS = 0;
#endif

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy) - ivec2(u_first);
    place[AXIS] = 2 * place[AXIS] - 1;
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        float weight = i == 0 || i == 3 ? 0.125 : 0.375;
        bool is_known = place[AXIS] >= int(u_known.x) && place[AXIS] <= int(u_known.y);
        sum += is_known ? weight * texelFetch(u_source, place + ivec2(u_corner), 0).r : 0.0;
        ++place[AXIS];
    }
    o_mean = sum;
}
