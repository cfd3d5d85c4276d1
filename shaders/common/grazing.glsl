// How strong a shadow is under a light that stands low over the receiver.

uniform float u_strength;              // of a light low over the whole receiver (the sun)

#ifdef LAMP_IS_LOW
uniform mat3 u_receiver_from_pixel;    // canvas px - origin -> receiver (u, v) in px
uniform vec3 u_lamp_on_receiver;       // the lamp's foot (u, v) and its height, px
uniform vec2 u_grazing_sine;           // sines of the low angles between which the shadow fades in

float grazing_strength(vec2 pixel) {
    vec3 h = u_receiver_from_pixel * vec3(pixel, 1.0);
    vec2 away = h.xy / h.z - u_lamp_on_receiver.xy;
    float height = u_lamp_on_receiver.z;
    float sine = height * inversesqrt(height * height + dot(away, away));
    return u_strength * smoothstep(u_grazing_sine.x, u_grazing_sine.y, sine);
}
#else
float grazing_strength(vec2 pixel) {
    return u_strength;
}
#endif
