// The part of a unit cell that lies on the full side of an edge.

// Coverage of the cell [-1/2, 1/2]² by the half-plane where value + slope·x >= 0: the exact box filter of an edge.
// It is the twice-integrated step, differenced over the cell's four corners.
float cell_coverage(float value, vec2 slope) {
    vec2 s = max(abs(slope), vec2(0.02));
    float reach = 0.5 * (s.x + s.y);
    if (abs(value) >= reach) {
        return value > 0.0 ? 1.0 : 0.0;
    }
    float inner = 0.5 * (s.x - s.y);
    vec4 corners = max(value + vec4(reach, inner, -inner, -reach), 0.0);
    corners *= corners;
    return clamp((corners.x - corners.y - corners.z + corners.w) / (2.0 * s.x * s.y), 0.0, 1.0);
}
