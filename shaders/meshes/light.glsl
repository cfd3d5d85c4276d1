// How much of a cell the meshes leave lit. The light's map tells which triangles may stand between; whether one does is
// asked of itself, so that edges lie where they are, no surface darkens itself and no gap is left at a contact. Only
// where triangles are smaller than the map's texels the texels decide. Switches:
//   ALL_AROUND   the lamp stands among what it lights: its map is a cube of six faces

#include "meshes/triangles.glsl"
#include "common/samples.glsl"

#ifdef ALL_AROUND
const int FACES = 6;                   // of a cube around the lamp: away, back, right, left, up, down
const int REACH = 4;                   // texels around a place, each way, whose triangles are asked: its own are wide
#else
const int FACES = 1;
const int REACH = 2;
#endif

uniform sampler2D u_map;               // how far the nearest triangle is from the light, and which, counted from 1
uniform mat3 u_map_axes;               // rows: across, up, away from the light
uniform vec4 u_map_windows[FACES];     // centre and half size of what a face shows; for a lamp in parts of the distance
uniform vec4 u_map_boxes[FACES];       // its first texel in the map and how many it has; 0 for none
uniform vec4 u_map_light;              // homogeneous
uniform vec3 u_map_shift;              // from the places asked about to those of the triangles

const int LIT = 0, DARK = 1, EDGE = 2;
const float LIFT_PX = 0.05;            // what is no higher over a surface does not shade it
const float CLOSED_PX = 0.4;           // from here on a texel's triangle shades it, even if none is found between
const float HIGH_PX = 1.5;             // from here on nothing has to be asked

vec3 in_light(vec3 place) {
    return u_map_axes * (place - u_map_light.xyz * u_map_light.w);
}

#ifdef ALL_AROUND
int face_of(vec3 seen) {
    vec3 reach = abs(seen);
    int axis = reach.z >= max(reach.x, reach.y) ? 0 : reach.x >= reach.y ? 1 : 2;
    float away = axis == 0 ? seen.z : axis == 1 ? seen.x : seen.y;
    return 2 * axis + (away < 0.0 ? 1 : 0);
}

// A place as a face has it: across, up, away.
vec3 on_face(int face, vec3 seen) {
    vec3 turned = face < 2 ? seen : face < 4 ? seen.yzx : seen.zxy;
    return vec3(turned.xy, (face & 1) == 0 ? turned.z : -turned.z);
}

vec3 from_face(int face, vec3 own) {
    own.z = (face & 1) == 0 ? own.z : -own.z;
    return face < 2 ? own : face < 4 ? own.zxy : own.yzx;
}
#else
int face_of(vec3 seen) {
    return 0;
}

vec3 on_face(int face, vec3 seen) {
    return seen;
}

vec3 from_face(int face, vec3 own) {
    return own;
}
#endif

// Where on a face a place is seen.
vec2 flat_on(int face, vec3 seen) {
    vec3 own = on_face(face, seen);
    return u_map_light.w == 0.0 ? own.xy : own.xy / max(own.z, 1e-6);
}

vec2 texel_on(int face) {
    return 2.0 * u_map_windows[face].zw / max(u_map_boxes[face].zw, vec2(1.0));
}

// A surface as the light sees it: its plane, positive toward the light.
vec4 toward_light(vec3 normal, vec3 seen) {
    vec3 up = u_map_axes * normal;
    up *= dot(up, u_map_light.w == 0.0 ? vec3(0.0, 0.0, -1.0) : -seen) < 0.0 ? -1.0 : 1.0;
    return vec4(up, -dot(up, seen));
}

// How high over a surface the triangle lies that the map holds, and its number. It is far below where it cannot shade
// the place: from there and from the light its front is seen alike, as where a surface bends upward. What is asked about
// beyond the rim of a face of the cube is found on the next one, so that there is no seam.
vec2 over_surface(int face, vec2 asked, vec4 surface, vec3 place) {
#ifdef ALL_AROUND
    vec3 toward = from_face(face, vec3(asked, 1.0));
    face = face_of(toward);
    asked = flat_on(face, toward);
#endif
    vec4 window = u_map_windows[face], box = u_map_boxes[face];
    vec2 corner = floor(((asked - window.xy) / window.zw * 0.5 + 0.5) * box.zw);
    bool inside = all(greaterThanEqual(corner, vec2(0.0))) && all(lessThan(corner, box.zw));
    vec2 found = inside ? texelFetch(u_map, ivec2(box.xy + corner), 0).rg : vec2(0.0);
    vec2 across = (corner + 0.5) * texel_on(face) - window.zw + window.xy;
    vec3 seen = from_face(face, vec3(u_map_light.w == 0.0 ? across : across * found.x, found.x));
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
    for (int index = asked ? 0 : REACH * REACH; index < REACH * REACH; ++index) {
        vec3 seen = in_light(place);
        vec4 surface = toward_light(normal, seen);
        int face = face_of(seen);
        vec2 beside = vec2(float(index % REACH), float(index / REACH)) - 0.5 * float(REACH - 1);
        vec2 found = over_surface(face, flat_on(face, seen) + beside * texel_on(face), surface, place);
        // What is dark without a triangle is told by the nearest four.
        least = max(abs(beside.x), abs(beside.y)) < 1.0 ? min(least, found.x) : least;
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
    int face = face_of(seen);
    vec2 middle = flat_on(face, seen), texel = texel_on(face);
    vec2 reach = abs(flat_on(face, in_light(place + cell_world[0])) - middle)
               + abs(flat_on(face, in_light(place + cell_world[1])) - middle);
    // So far that the middles of the texels found there lie around the cell.
    reach = min(0.5 * reach, 64.0 * texel) + 0.5 * texel;
    float least = 1e9, most = -1e9;
    for (int index = 0; index < 4; ++index) {
        vec2 corner = vec2(float(index & 1), float(index >> 1)) * 2.0 - 1.0;
        float height = over_surface(face, middle + corner * reach, surface, place).x;
        least = min(least, height);
        most = max(most, height);
    }
    bool before = FACES > 1 || u_map_light.w == 0.0 || seen.z > 0.0;
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
