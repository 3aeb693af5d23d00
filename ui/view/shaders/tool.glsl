// Instruments: brushed steel, black insulation, pale ceramic, and a tip that glows faintly; suture
// thread; a patch.
in vec3 v_position;
in vec3 v_normal;
in vec4 v_rest;    // material, along the shaft [mm], unused
in vec4 v_damage;
in vec2 v_extra;
uniform float energised;  // 0..1
uniform vec3 glow;        // colour of the pedal in use
uniform vec3 tissue_bounce;
uniform sampler2D noise_map;
out vec4 colour;

// What polished steel sees: the red field below, the dark cavity above, the scope's own light.
vec3 surroundings(vec3 r) {
    float down = smoothstep(0.05, -0.95, r.z);
    vec3 c = mix(vec3(0.030, 0.022, 0.020), tissue_bounce, down);
    // The wet field glitters: bright patches, so that polished faces are never of one colour.
    c *= 0.25 + 1.6 * texture(noise_map, r.xy * 0.30 + vec2(0.13, 0.41)).g;
    return c + vec3(0.9) * pow(saturate(dot(r, -view_axis)), 24.0);
}

void main() {
    vec3 n = normalize(v_normal);
    vec3 v = normalize(eye - v_position);
    vec3 l = normalize(light_a - v_position);
    if (dot(n, v) < 0.0) n = -n;
    float reach = min(light_reach(v_position), 2.6);
    float scratch = texture(noise_map, vec2(v_rest.y * 0.05, v_rest.z * 1.7)).r;
    float nl = saturate(dot(n, l));
    vec3 result;
    if (v_rest.x < 0.5) {  // steel
        vec3 f0 = vec3(0.397, 0.418, 0.434);
        float a = 0.05 + 0.06 * scratch;
        vec3 r = reflect(-v, n);
        vec3 f = f0 + (1.0 - f0) * pow(1.0 - saturate(dot(n, v)), 5.0);
        result = f * surroundings(r) * reach * 0.75;
        result += f0 * min(highlight(n, v, l, a, 1.0), 14.0) * reach;
        result += f0 * 0.05 * (0.3 + 0.7 * nl) * reach * (0.6 + 0.7 * scratch);
    } else if (v_rest.x < 1.5) {  // insulation
        vec3 base = vec3(0.007, 0.008, 0.009);
        result = base * nl * reach + highlight(n, v, l, 0.10, 0.04) * reach * (0.7 + 0.5 * scratch);
        result += 0.03 * surroundings(reflect(-v, n)) * reach;
        // Laser-marked depth rings, every 10 mm.
        float ring = smoothstep(0.30, 0.15, abs(mod(v_rest.y, 10.0) - 9.0));
        result += ring * vec3(0.13, 0.13, 0.12) * nl * reach;
    } else if (v_rest.x > 3.5) {  // patch: pale felt of collagen, wet, drawn over what lies below
        float felt = texture(noise_map, v_rest.yz * 0.09).g;
        vec3 base = vec3(0.62, 0.57, 0.50) * (0.86 + 0.28 * felt);
        result = base * (0.18 + 0.62 * nl) * reach;
        result += highlight(n, v, l, 0.16 + 0.10 * felt, 0.045) * reach;
        // Seen along its plane one looks through more of it.
        float through = pow(1.0 - saturate(dot(n, v)), 2.0);
        colour = vec4(result, mix(0.66, 0.96, through));
        return;
    } else if (v_rest.x > 2.5) {  // suture thread: dyed monofilament, wet
        vec3 base = vec3(0.035, 0.030, 0.150);
        result = base * (0.20 + 0.80 * nl) * reach + highlight(n, v, l, 0.12, 0.05) * reach;
    } else {  // ceramic
        vec3 base = vec3(0.62, 0.55, 0.44);
        result = base * (0.15 + 0.85 * nl) * reach * 0.8 + highlight(n, v, l, 0.06, 0.04) * reach;
    }
    float tip = smoothstep(3.0, 0.0, v_rest.y) * step(v_rest.x, 0.5);
    result += energised * tip * tip * glow * (0.07 + 0.05 * sin(time_s * 173.0));
    colour = vec4(result, 0.0);  // alpha tells the edges of instruments, see compose.glsl
}
