// Waves move the place at which a shadow is read (paper 3.6.2, spec 4). u and v are those of the blurred shadow.

const int MAX_RIPPLES = 2;

uniform int u_ripple_count;
uniform vec4 u_ripples[MAX_RIPPLES];   // k in radians per px of u and v; the phase; the amplitude in px
uniform vec4 u_ripple_matrices[MAX_RIPPLES];   // A00, A01, A10, A11 as parts of the amplitude
uniform vec4 u_heave;                  // rows of the matrix from (cos, sin) on the ground to u and v
uniform float u_anchor_px;             // in v; 0 where the waves have their full strength everywhere

// Moves a place; returns by how much the new place changes with the old one.
mat2 moved_by_waves(inout vec2 place) {
    vec2 sum = vec2(0.0);
    mat2 change = mat2(0.0);
    for (int i = 0; i < u_ripple_count; ++i) {
        vec4 ripple = u_ripples[i];
        float psi = dot(ripple.xy, place) + ripple.z;
        mat2 matrix = mat2(u_ripple_matrices[i].xy, u_ripple_matrices[i].zw);
        sum += ripple.w * (matrix * vec2(cos(psi), sin(psi)));
        change += outerProduct(ripple.w * (matrix * vec2(-sin(psi), cos(psi))), ripple.xy);
    }
    mat2 heave = mat2(u_heave.xz, u_heave.yw);
    float strength = u_anchor_px > 0.0 ? min(abs(place.y) / u_anchor_px, 1.0) : 1.0;
    vec2 grows = vec2(0.0, strength < 1.0 ? sign(place.y) / u_anchor_px : 0.0);
    mat2 result = mat2(1.0) + heave * (strength * change + outerProduct(sum, grows));
    place += strength * (heave * sum);
    return result;
}
