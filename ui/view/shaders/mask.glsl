// Fills depth where the round stop of the optic hides the picture: those pixels are never shaded.
in vec2 v_uv;
out vec4 colour;
void main() {
    if (length(v_uv * 2.0 - 1.0) < 1.01) discard;
    colour = vec4(0.0);
}
