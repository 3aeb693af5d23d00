// Instruments: brushed steel, black insulation, pale ceramic, and a tip that glows faintly; suture
// thread; a patch.
in vec3 v_position;
in vec3 v_normal;
in vec4 v_rest;    // material; along the shaft [mm] and around it, of a patch its place at rest; rim
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

// Standing fluid (depth and depth of blood in it [mm]), jets (along, around, share of the way),
// crumbs of char and spots of blood: translucent, wet.
vec4 fluid_colour(vec3 n, vec3 v, vec3 l, float reach) {
    float shade = tool_shade(v_position, n, l);
    float nl = saturate(dot(n, l)), nv = saturate(dot(n, v));
    if (v_rest.x > 7.5) {  // spot of blood
        vec3 base = vec3(0.115, 0.006, 0.005);
        vec3 wet = base * (0.15 + 0.85 * nl) * reach * shade;
        wet += min(highlight(n, v, l, 0.08, 0.04), 3.0) * reach * shade;
        return vec4(wet, 0.93 * smoothstep(0.0, 0.35, v_rest.w));
    }
    if (v_rest.x > 6.5) {  // crumb of char
        float rough = texture(noise_map, vec2(0.31 * v_rest.y + 0.4 * v_rest.z, 0.7 * v_rest.w)).r;
        vec3 base = mix(vec3(0.006, 0.005, 0.005), vec3(0.050, 0.032, 0.022), sq(rough));
        vec3 dull = base * (0.2 + 0.8 * nl) * reach * shade;
        return vec4(dull + min(highlight(n, v, l, 0.30, 0.04), 1.0) * reach * shade, 1.0);
    }
    if (v_rest.x > 5.5) {  // jet: clear, seen by its edges and by what it mirrors; it ripples
        float run = v_rest.y * 0.09 - time_s * 9.0;
        vec4 ripple = texture(noise_map, vec2(run, 0.32 * v_rest.z));
        vec3 m = normalize(n + 0.9 * (ripple.bar - 0.5));
        float edge = pow(1.0 - saturate(dot(m, v)), 1.5);
        // Its round surface gathers the light of the scope to streaks, which run with it.
        float streak = smoothstep(0.52, 0.80, ripple.r) * (0.4 + 0.6 * ripple.b);
        vec3 c = vec3(0.62, 0.61, 0.62) * (0.15 + 0.85 * edge + 0.9 * streak) * reach;
        c += 0.6 * surroundings(reflect(-v, m)) * reach;
        c += min(highlight(m, v, l, 0.05, 0.05), 8.0) * reach;
        // Air gets into it on its way: towards its end it turns white and frays.
        float froth = smoothstep(0.45, 1.0, v_rest.w) * (0.35 + 0.65 * ripple.g);
        c += vec3(0.30) * froth * reach;
        float frayed = smoothstep(0.25, 0.75, ripple.g + 0.6 * (1.0 - v_rest.w));
        return vec4(c, saturate(0.24 + 0.55 * edge + 0.35 * streak + 0.35 * froth) *
                           mix(0.45, 1.0, frayed) * (1.0 - smoothstep(0.90, 1.0, v_rest.w)));
    }
    // Pool. Blood takes the light as in sim/fluid/pool.cpp; without it the surface shows by what it
    // mirrors and by a little haze.
    float depth = v_rest.y, hidden = 1.0 - exp(-30.0 * max(v_rest.z, 0.0));
    vec2 q = v_position.xy;
    vec4 swell = texture(noise_map, q * 0.045 + vec2(0.021, -0.017) * time_s);
    vec4 swell2 = texture(noise_map, q * 0.11 - vec2(0.027, 0.020) * time_s);
    vec3 m = normalize(n + vec3((swell.ba - 0.5) * 0.10 + (swell2.ba - 0.5) * 0.05, 0.0));
    float shore = smoothstep(0.05, 0.22, depth);
    vec3 thick = vec3(0.150, 0.010, 0.008), thin = vec3(0.46, 0.10, 0.080);
    vec3 tint = mix(thin, thick, sq(hidden)) * (0.30 + 0.70 * saturate(dot(m, l)));
    float mirror = 0.02 + 0.98 * pow(1.0 - saturate(dot(m, v)), 5.0);
    vec3 shine = mirror * surroundings(reflect(-v, m)) * reach * 2.0 +
                 min(highlight(m, v, l, 0.012, 0.02), 20.0) * reach * shade;
    // Its rim climbs the tissue a little and catches the light all round.
    float rim = smoothstep(0.03, 0.12, depth) * (1.0 - smoothstep(0.12, 0.40, depth));
    shine += rim * (0.05 + 0.10 * swell2.r) * reach * shade;
    float body = max(hidden, 0.20 * (1.0 - exp(-1.2 * depth)));
    float gloss = saturate(dot(shine, vec3(0.34)));
    float alpha = shore * saturate(0.97 * body + gloss);
    vec3 c = (tint * reach * shade * body + shine) / max(saturate(body + gloss), 1e-3);
    return vec4(c, alpha);
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
        // A needle is thinner than what it mirrors: along it the light runs together to a line.
        float wire = step(1e4, v_rest.y);
        float a = mix(0.05 + 0.06 * scratch, 0.13, wire);
        vec3 r = reflect(-v, n);
        vec3 f = f0 + (1.0 - f0) * pow(1.0 - saturate(dot(n, v)), 5.0);
        result = f * surroundings(r) * reach * 0.75;
        result += f0 * min(highlight(n, v, l, a, 1.0), 14.0) * reach;
        float dull = mix(0.05 * (0.6 + 0.7 * scratch), 0.20 * sq(saturate(dot(n, v))), wire);
        result += f0 * dull * (0.3 + 0.7 * nl) * reach;
    } else if (v_rest.x < 1.5) {  // insulation
        vec3 base = vec3(0.007, 0.008, 0.009);
        result = base * nl * reach + highlight(n, v, l, 0.10, 0.04) * reach * (0.7 + 0.5 * scratch);
        result += 0.03 * surroundings(reflect(-v, n)) * reach;
        // Laser-marked depth rings, every 10 mm.
        float ring = smoothstep(0.30, 0.15, abs(mod(v_rest.y, 10.0) - 9.0));
        result += ring * vec3(0.13, 0.13, 0.12) * nl * reach;
    } else if (v_rest.x > 4.5) {
        colour = fluid_colour(n, v, l, reach);
        return;
    } else if (v_rest.x > 3.5) {  // patch: soaked felt of collagen, drawn over what lies below
        vec2 q = v_rest.yz;
        vec4 soaked = texture(noise_map, q * 0.11);
        vec4 felt = texture(noise_map, q * 0.43 + vec2(0.37, 0.11));
        // Fibres lie every way and curl.
        vec2 w = q + 1.6 * (soaked.rg - 0.5);
        float fibre = max(texture(noise_map, vec2(w.x * 0.22 + w.y * 0.10, w.y * 0.62 - w.x * 0.25)).r,
                          texture(noise_map, vec2(w.x * 0.60 + w.y * 0.22, w.y * 0.20 - w.x * 0.12)).g);
        float pale = saturate(1.3 * fibre + 1.3 * (soaked.g - 0.5) - 0.30);
        // Where it is soaked through it takes the red of what lies below.
        vec3 base = mix(vec3(0.54, 0.37, 0.29), vec3(0.68, 0.57, 0.46), pale);
        vec3 t = normalize(vec3(1.0, 0.0, 0.0) - n * n.x);
        vec3 b = cross(n, t);
        vec2 slope = (soaked.ba - 0.5) * 0.60 + (felt.ba - 0.5) * 0.45;
        vec3 nf = normalize(n - t * slope.x - b * slope.y);
        float shade = tool_shade(v_position, n, l);
        vec3 wrap = vec3(0.35, 0.20, 0.14);
        vec3 soft = clamp((dot(nf, l) + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0, 1.0);
        result = base * soft * reach * shade + base * vec3(0.055, 0.024, 0.020);
        result += min(highlight(nf, v, l, 0.05 + 0.04 * felt.r, 0.028), 3.0) * reach * shade;
        // The cut edge is thick: fibres stand out of it, and it darkens towards the tissue.
        float ragged = v_rest.w + 0.16 * (felt.r - 0.5) + 0.10 * (fibre - 0.5);
        float edge = smoothstep(0.74, 0.94, ragged);
        result *= 1.0 - 0.50 * edge;
        float through = pow(1.0 - saturate(dot(n, v)), 2.0);
        // Seen along its plane one looks through more of it.
        float cover = mix(0.68 + 0.18 * pale, 0.97, max(through, edge));
        colour = vec4(result, cover * (1.0 - smoothstep(0.97, 1.03, ragged)));
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
