// The uterine wall behind everything: dark, red-brown, far from the light.
in vec3 v_position;
in vec3 v_normal;
in vec4 v_rest;
in vec4 v_damage;
in vec2 v_extra;
uniform sampler2D noise_map;
out vec4 colour;
void main() {
    vec2 q = vec2(atan(v_rest.y, v_rest.x), v_rest.z / 40.0);
    float f = texture(noise_map, q * 1.1).r, g = texture(noise_map, q * 3.7).g;
    vec3 albedo = vec3(0.156, 0.023, 0.018) * (0.6 + 0.9 * f) + vec3(0.02, 0.004, 0.006) * g;
    vec3 n = normalize(v_normal);
    vec3 l = normalize(light_a - v_position), v = normalize(eye - v_position);
    if (dot(n, v) < 0.0) n = -n;
    float reach = light_reach(v_position);
    vec3 lit = albedo * (0.15 + 0.85 * saturate(dot(n, l))) * (reach + 0.02);
    colour = vec4(lit + 0.3 * highlight(n, v, l, 0.16, 0.03) * reach, 1.0);
}
