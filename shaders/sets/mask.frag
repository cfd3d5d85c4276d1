#version 330 core
// The part of a receiver that is seen, pixel by pixel, times the shadow on it; receivers then add up to the picture.
// A receiver, and what bodies take of it from the camera and from the light, are convex regions of lines and conics.
// Switches:
//   OWN_SHADOW          writes what is seen and taken from the light, instead of the seen and lit part of u_coverage
//   DARK_WHEN_TURNED    with OWN_SHADOW: a face that turns away from the light grows dark
//   LAMP_IS_LOW         with OWN_SHADOW: see common/grazing.glsl
//   PAST_MESHES         meshes may hide a part of the receiver
//   MESHES              meshes take the light, too

#include "common/edge.glsl"
#ifdef OWN_SHADOW
#include "common/grazing.glsl"
#else
uniform sampler2D u_coverage;          // the shadow on this receiver as if it were alone
#endif

#ifdef PAST_MESHES
#include "common/samples.glsl"

uniform sampler2D u_past;              // in which samples of each pixel no mesh hides it, a bit for each

int past_at(ivec2 at) {
    return int(texelFetch(u_past, at, 0).r * 65535.0 + 0.5);
}

#endif
#ifdef MESHES
#include "meshes/light.glsl"

uniform vec4 u_lift_rows[4];           // canvas px - origin -> the receiver's points around the origin of the meshes
uniform vec3 u_normal;                 // of the receiver

vec3 lifted(vec2 pixel) {
    vec4 place = vec4(pixel, 1.0, 0.0);
    return vec3(dot(u_lift_rows[0], place), dot(u_lift_rows[1], place), dot(u_lift_rows[2], place))
         / dot(u_lift_rows[3], place);
}

// How much of some samples of a pixel is lit.
float lit_at(vec2 pixel, int samples) {
    mat2x3 pixel_world = mat2x3(lifted(pixel + vec2(0.5, 0.0)) - lifted(pixel - vec2(0.5, 0.0)),
                                lifted(pixel + vec2(0.0, 0.5)) - lifted(pixel - vec2(0.0, 0.5)));
    return mesh_lit(lifted(pixel), u_normal, pixel_world, FINE, samples);
}
#endif

uniform vec2 u_origin_px;              // canvas px around which all forms are given, for precision
uniform vec4 u_regions[MAX_REGIONS];   // first line, line behind the last, conic or -1, flags
uniform vec4 u_lines[MAX_LINES];       // (a, b, c, -): signed distance in px, >= 0 inside
uniform vec4 u_conics[2 * MAX_CONICS]; // (xx, xy, yy, x), (y, 1, -, -): >= 0 inside
uniform int u_region_count;

out float o_coverage;

const int CELLS = 2;                   // each way; an edge within a cell is integrated as if it were straight there
const float CELL = 1.0 / float(CELLS);
const float CLEAR_PX = 0.75;           // a line no nearer to a pixel's middle misses the pixel

const int LAST = 1, OVERLAPS = 2, OWN = 4, LIGHT = 8;

float conic_coverage(int index, vec2 here) {
    vec4 square = u_conics[2 * index];
    vec4 rest = u_conics[2 * index + 1];
    vec2 slope = vec2(2.0 * square.x * here.x + square.y * here.y + square.w,
                      square.y * here.x + 2.0 * square.z * here.y + rest.x);
    float value = 0.5 * dot(slope + vec2(square.w, rest.x), here) + rest.y;
    // In px, so that the slope is neither too small nor too large for the edge's integral.
    float steep = max(length(slope), 1e-30);
    return cell_coverage(value / steep, slope / steep * CELL);
}

float region_coverage(vec4 region, vec2 here) {
    float covered = 1.0;
    for (int index = int(region.x); index < int(region.y); ++index) {
        vec3 line = u_lines[index].xyz;
        covered *= cell_coverage(dot(line, vec3(here, 1.0)), line.xy * CELL);
        // Loops are what a software rasteriser leaves early.
        if (covered == 0.0) {
            break;
        }
    }
    return region.z < 0.0 ? covered : covered * conic_coverage(int(region.z), here);
}

// Into how many cells, each way, a pixel is split: one where no region's edge comes near.
int cells_at(vec2 pixel) {
    float nearest = CLEAR_PX;
    for (int index = 0; index < u_region_count; ++index) {
        vec4 region = u_regions[index];
        // How deep within the region; a conic may run anywhere within its lines.
        float depth = region.z < 0.0 ? CLEAR_PX : 0.0;
        for (int line = int(region.x); line < int(region.y); ++line) {
            depth = min(depth, dot(u_lines[line].xyz, vec3(pixel, 1.0)));
            if (depth <= -CLEAR_PX) {
                break;
            }
        }
        nearest = min(nearest, abs(depth));
    }
    return nearest < CLEAR_PX ? CELLS : 1;
}

// Seen part and lit part of a cell.
vec2 seen_and_lit(vec2 here) {
    vec2 left = vec2(1.0);
    float taken = 0.0;
    for (int index = 0; index < u_region_count; ++index) {
        vec4 region = u_regions[index];
        int flags = int(region.w);
        float covered = region_coverage(region, here);
        taken = (flags & OVERLAPS) != 0 ? max(taken, covered) : min(taken + covered, 1.0);
        if ((flags & LAST) != 0) {
            float kept = (flags & OWN) != 0 ? taken : 1.0 - taken;
            left *= (flags & LIGHT) != 0 ? vec2(1.0, kept) : vec2(kept, 1.0);
            taken = 0.0;
        }
    }
    return left;
}

void main() {
    vec2 pixel = gl_FragCoord.xy - u_origin_px;
    float sum = 0.0;
#ifdef PAST_MESHES
    int samples = past_at(ivec2(gl_FragCoord.xy));
#elif defined(MESHES)
    const int samples = WHOLE;
#endif
#ifdef MESHES
    float lit = lit_at(pixel, samples);
#else
    const float lit = 1.0;
#endif
#ifdef OWN_SHADOW
    float strength = grazing_strength(pixel);
    int cells = cells_at(pixel);
#else
    float shadow = texelFetch(u_coverage, ivec2(gl_FragCoord.xy), 0).r;
    int cells = shadow > 0.0 ? cells_at(pixel) : 0;
#endif
    for (int index = 0; index < cells * cells; ++index) {
        vec2 offset = cells == 1 ? vec2(0.0) : (vec2(float(index % CELLS), float(index / CELLS)) + 0.5) * CELL - 0.5;
        vec2 left = seen_and_lit(pixel + offset);
#if defined(DARK_WHEN_TURNED)
        sum += left.x * (1.0 - strength * left.y * lit);
#elif defined(OWN_SHADOW)
        sum += left.x * strength * (1.0 - left.y * lit);
#else
        sum += left.x * left.y * lit;
#endif
    }
    o_coverage = sum / float(max(cells * cells, 1));
#ifdef PAST_MESHES
    o_coverage *= count_of(samples) / 16.0;
#endif
#ifndef OWN_SHADOW
    o_coverage *= shadow;
#endif
}
