in vec2 v_uv;
in vec4 v_tint;
in vec2 v_kind;
uniform sampler2D letters;
out vec4 colour;
void main() {
    float alpha = v_tint.a;
    if (v_kind.x < 0.5) {
        alpha *= texture(letters, v_uv).r;
    } else if (v_kind.x > 1.5) {
        // Ring: uv in -1..1, parameter = inner radius; clockwise share in tint is drawn by the caller.
        float r = length(v_uv), w = fwidth(r);
        alpha *= smoothstep(1.0, 1.0 - 1.5 * w, r) * smoothstep(v_kind.y - 1.5 * w, v_kind.y, r);
    }
    colour = vec4(v_tint.rgb, alpha);
}
