// How a shadow changes with the distance from the contact line. Switches:
//   FADING   its opacity falls
//   TINTED   its colour passes over into a second one
//   MEASURED the distance is that of a picture, where it has any

#if defined(FADING) || defined(TINTED)
uniform vec2 u_origin_px;      // canvas px around which the forms below are given, for precision
uniform vec3 u_away;           // their quotient is v, the distance from the contact line on the receiver
uniform vec3 u_lift;

#ifdef MEASURED
uniform sampler2D u_distances;   // px, along the receivers
#endif

float distance_at(vec2 pixel) {
#ifdef MEASURED
    float measured = texelFetch(u_distances, ivec2(pixel), 0).r;
    if (measured > 0.0) {
        return measured;
    }
#endif
    vec3 place = vec3(pixel - u_origin_px, 1.0);
    return abs(dot(u_away, place) / dot(u_lift, place));
}
#endif

#ifdef FADING
uniform float u_fade_px;
uniform float u_fade_curve;
#endif

float opacity_at(vec2 pixel, float opacity) {
#ifdef FADING
    return opacity * pow(max(1.0 - distance_at(pixel) / u_fade_px, 0.0), u_fade_curve);
#else
    return opacity;
#endif
}

#ifdef TINTED
uniform vec3 u_tip_color;
uniform float u_tip_px;
#endif

vec3 color_at(vec2 pixel, vec3 color) {
#ifdef TINTED
    return mix(color, u_tip_color, min(distance_at(pixel) / u_tip_px, 1.0));
#else
    return color;
#endif
}
