// The standard deviation of the blur at a distance from the contact line, px of the receiver (spec 3).

uniform float u_amount_px;
uniform float u_distance_px;   // 0: the amount everywhere
uniform float u_base_px;       // what the edge needs besides, at the contact line ...
uniform float u_slope;         // ... and with every px away from it

float sigma_at(float v) {
    float part = u_distance_px > 0.0 ? min(abs(v) / u_distance_px, 1.0) : 1.0;
    return length(vec2(u_amount_px * part, u_base_px + u_slope * abs(v)));
}
