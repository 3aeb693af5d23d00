in float v_cut;
out vec4 colour;
void main() {
    float r = length(gl_PointCoord * 2.0 - 1.0);
    if (v_cut > 0.5 || r > 1.0) discard;
    colour = vec4(0.10, 0.75, 0.82, 0.75 * (1.0 - smoothstep(0.6, 1.0, r)));
}
