// Centre-weighted mean of the log luminance, and the camera's slow iris.
in vec2 v_uv;
uniform sampler2D bright;
uniform sampler2D previous;
uniform float adapt;   // 0..1 share of the way to go in this frame
uniform float target;  // linear value that the mean is brought to
out vec4 colour;
void main() {
    float sum = 0.0, weights = 0.0;
    for (int j = 0; j < 12; ++j) {
        for (int i = 0; i < 12; ++i) {
            vec2 p = (vec2(i, j) + 0.5) / 12.0;
            float w = smoothstep(1.0, 0.2, length(p * 2.0 - 1.0));
            sum += w * texture(bright, p).a;
            weights += w;
        }
    }
    float mean = exp2(sum / weights);
    float wanted = clamp(target / mean, 0.15, 12.0);
    float before = texture(previous, vec2(0.5)).r;
    float now = before > 0.0 ? exp2(mix(log2(before), log2(wanted), adapt)) : wanted;
    colour = vec4(now, mean, 0.0, 1.0);
}
