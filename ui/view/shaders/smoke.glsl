in vec2 v_corner;
in vec2 v_look;
in vec3 v_position;
uniform sampler2D noise_map;
out vec4 colour;
void main() {
    float r = dot(v_corner, v_corner);
    if (r > 1.0) discard;
    float puff = texture(noise_map, v_corner * 0.16 + vec2(v_look.y, 3.1 * v_look.y)).r;
    float alpha = v_look.x * sq(1.0 - r) * smoothstep(0.25, 0.75, puff);
    float reach = min(light_reach(v_position), 4.0);
    colour = vec4(vec3(0.485, 0.456, 0.423) * (0.04 + 0.75 * reach), alpha);
}
