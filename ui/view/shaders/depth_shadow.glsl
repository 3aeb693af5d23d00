// Darkness right below the instruments, as under a lamp overhead: it says how high they are.
// Multiplied onto the tissue.
in vec3 v_position;
in float v_share;  // of the shadow: less towards the end of what is drawn
out vec4 colour;

const float kSlope = 0.13;  // of the soft border, for every mm of height
const float kFade = 9.0;    // height over which the shadow gets fainter [mm]
const float kDark = 0.85;

void main() {
    float light = 1.0;
    for (int i = 0; i < capsule_count; ++i) {
        vec3 a = capsule_a[i].xyz, b = capsule_b[i].xyz;
        vec2 ab = b.xy - a.xy;
        float t = clamp(dot(v_position.xy - a.xy, ab) / max(dot(ab, ab), 1e-4), 0.0, 1.0);
        vec3 q = mix(a, b, t);
        float height = q.z - v_position.z;
        // What stands above the instrument is not in its shadow.
        float below = smoothstep(-0.6, 0.0, height);
        height = max(height, 0.0);
        float core = max(capsule_a[i].w, 0.45), soft = 0.15 + kSlope * height;
        float r = length(v_position.xy - q.xy);
        float inside = 1.0 - smoothstep(max(core - soft, 0.0), core + soft, r);
        light *= 1.0 - kDark * below * inside * exp(-height / kFade);
    }
    colour = vec4(vec3(mix(1.0, light, v_share)), 1.0);
}
