in float v_kind;
out vec4 colour;
void main() {
    float r = length(gl_PointCoord * 2.0 - 1.0);
    bool cut = v_kind > 0.5 && v_kind < 1.5;
    if (cut || r > 1.0) discard;
    float edge = 1.0 - smoothstep(0.6, 1.0, r);
    // Guide light for the planned line, surgeon's ink for marked tissue.
    colour = v_kind > 1.5 ? vec4(0.16, 0.05, 0.30, 0.85 * edge) : vec4(0.10, 0.75, 0.82, 0.75 * edge);
}
