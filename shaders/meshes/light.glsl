// How much of a cell the meshes leave lit. The light's map tells which triangles may stand between; whether one does is
// asked of itself, so that edges lie where they are, no surface darkens itself and no gap is left at a contact. Only
// where triangles are smaller than the map's texels the texels decide.

#include "meshes/triangles.glsl"
#include "common/samples.glsl"

uniform sampler2D u_map;               // how far the nearest triangle is from the light, and which, counted from 1
uniform vec2 u_map_size;               // texels
uniform mat3 u_map_axes;               // rows: across, up, away from the light
uniform vec4 u_map_window;             // centre and half size of what the map shows; for a lamp in parts of the distance
uniform vec4 u_map_light;              // homogeneous
uniform vec3 u_map_shift;              // from the places asked about to those of the triangles

const int LIT = 0, DARK = 1, EDGE = 2;
const float LIFT_PX = 0.05;            // what is no higher over a surface does not shade it
const float CLOSED_PX = 0.4;           // from here on a texel's triangle shades it, even if none is found between
const float HIGH_PX = 1.5;             // from here on nothing has to be asked

vec3 in_light(vec3 place) {
    return u_map_axes * (place - u_map_light.xyz * u_map_light.w);
}

vec2 texel_of(vec3 seen) {
    vec2 flat_place = u_map_light.w == 0.0 ? seen.xy : seen.xy / max(seen.z, 1e-6);
    return ((flat_place - u_map_window.xy) / u_map_window.zw * 0.5 + 0.5) * u_map_size;
}

// A surface as the light sees it: its plane, positive toward the light.
vec4 toward_light(vec3 normal, vec3 seen) {
    vec3 up = u_map_axes * normal;
    up *= dot(up, u_map_light.w == 0.0 ? vec3(0.0, 0.0, -1.0) : -seen) < 0.0 ? -1.0 : 1.0;
    return vec4(up, -dot(up, seen));
}

// How high over a surface the triangle lies that the map holds, and its number. It is far below where it cannot shade
// the place: from there and from the light its front is seen alike, as where a surface bends upward.
vec2 over_surface(vec2 texel, vec4 surface, vec3 place) {
    vec2 corner = floor(texel);
    bool inside = all(greaterThanEqual(corner, vec2(0.0))) && all(lessThan(corner, u_map_size));
    vec2 found = inside ? texelFetch(u_map, ivec2(corner), 0).rg : vec2(0.0);
    vec2 across = ((corner + 0.5) / u_map_size * 2.0 - 1.0) * u_map_window.zw + u_map_window.xy;
    vec3 seen = vec3(u_map_light.w == 0.0 ? across : across * found.x, found.x);
    vec4 plane = triangle_part(max(int(found.y), 1), 3);
    float before = (dot(plane.xyz, place) + plane.w) * sign(dot(plane, u_map_light));
    bool may_shade = found.y > 0.0 && before < -LIFT_PX;
    return vec2(may_shade ? dot(surface.xyz, seen) + surface.w : -1e9, found.y);
}

bool stands_between(vec3 place, vec3 normal, int triangle) {
    vec3 corner = triangle_part(triangle, 0).xyz;
    vec3 first = triangle_part(triangle, 1).xyz - corner;
    vec3 second = triangle_part(triangle, 2).xyz - corner;
    vec3 toward = u_map_light.xyz - u_map_light.w * place;
    vec3 beside = cross(toward, second);
    float turned = dot(first, beside);
    turned = abs(turned) < 1e-20 ? 1e-20 : turned;
    vec3 from_corner = place - corner;
    vec3 beyond = cross(from_corner, first);
    float a = dot(from_corner, beside) / turned;
    float b = dot(toward, beyond) / turned;
    float way = dot(second, beyond) / turned;
    const float RIM = 1e-4;
    return min(a, b) > -RIM && a + b < 1.0 + RIM && (u_map_light.w == 0.0 || way < 1.0)
        && way * abs(dot(normal, toward)) > LIFT_PX;
}

// Loops are what a software rasteriser leaves early: nothing of it is done where it is not asked.
bool is_dark(vec3 place, vec3 normal, bool asked) {
    float least = asked ? 1e9 : -1e9;
    bool dark = false;
    for (int index = asked ? 0 : 4; index < 4; ++index) {
        vec3 seen = in_light(place);
        vec4 surface = toward_light(normal, seen);
        vec2 texel = texel_of(seen) + vec2(float(index & 1), float(index >> 1)) - 0.5;
        vec2 found = over_surface(texel, surface, place);
        least = min(least, found.x);
        if (found.x > -HIGH_PX) {
            dark = dark || stands_between(place, normal, int(found.y));
        }
    }
    return dark || least > CLOSED_PX;
}

// Whether all of a cell is lit or dark, or has an edge.
int light_state(vec3 place, vec3 normal, mat2x3 cell_world) {
    vec3 seen = in_light(place);
    vec4 surface = toward_light(normal, seen);
    vec2 texel = texel_of(seen);
    vec2 reach = abs(texel_of(in_light(place + cell_world[0])) - texel)
               + abs(texel_of(in_light(place + cell_world[1])) - texel);
    reach = clamp(0.5 * reach, vec2(0.5), vec2(64.0));
    float least = 1e9, most = -1e9;
    for (int index = 0; index < 4; ++index) {
        vec2 corner = vec2(float(index & 1), float(index >> 1)) * 2.0 - 1.0;
        float height = over_surface(texel + corner * reach, surface, place).x;
        least = min(least, height);
        most = max(most, height);
    }
    bool before = u_map_light.w == 0.0 || seen.z > 0.0;
    return !before || most < LIFT_PX ? LIT : least > HIGH_PX ? DARK : EDGE;
}

// place: the middle of the cell; normal: of the surface, either way; side: how finely the cell is split at an edge;
// samples: where that is 4 by 4, which of them count.
float mesh_lit(vec3 place, vec3 normal, mat2x3 cell_world, int side, int samples) {
    place += u_map_shift;
    int state = light_state(place, normal, cell_world);
    int count = state == EDGE ? side * side : 0;
    float sum = 0.0, counted = 0.0;
    for (int index = 0; index < count; ++index) {
        vec2 offset = (vec2(float(index % side), float(index / side)) + 0.5) / float(side) - 0.5;
        offset = side == FINE ? sample_offset(index) : offset;
        if ((samples & (1 << index)) != 0) {
            sum += is_dark(place + cell_world * offset, normal, true) ? 0.0 : 1.0;
            counted += 1.0;
        }
    }
    return state == EDGE ? sum / max(counted, 1.0) : state == LIT ? 1.0 : 0.0;
}
