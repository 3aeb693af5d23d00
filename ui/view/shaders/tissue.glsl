// The operative field. Colours: palette of the anatomy reference, linear RGB. Everything that has a
// pattern is looked up by REST position, so that it sticks to the tissue.
// Three programs of one text: SHADOWED, with what tissue throws on tissue; the usual one; PLAIN, with a
// film that stands still and one highlight.
in vec3 v_position;
in vec3 v_normal;
in vec4 v_rest;
in vec4 v_damage;
in vec2 v_extra;
uniform sampler2D border_map;  // d_p, d_s [mm]
uniform sampler2D vessel_map;  // placode, arteriole, venule
uniform sampler2D skin_map;    // vernix, lanugo, mottle, pores
uniform sampler2D noise_map;   // fbm, fbm 2, slope x, slope y
uniform sampler2D wound_map;   // share that is gone within 0.3 mm and 1 mm, slope of the first
#ifdef SHADOWED
uniform sampler2DShadow light_map;
uniform mat4 light_projection;
#endif
uniform vec2 map_low;
uniform vec2 map_high;
uniform float skin_tile;
out vec4 colour;

const vec3 kSkin = vec3(0.694, 0.258, 0.238);
const vec3 kThinEdge = vec3(0.584, 0.130, 0.144);
const vec3 kJunction = vec3(0.807, 0.479, 0.423);
const vec3 kMembrane = vec3(0.815, 0.716, 0.672);
const vec3 kPlacode = vec3(0.479, 0.060, 0.050);
const vec3 kVessel = vec3(0.205, 0.007, 0.009);
const vec3 kVenule = vec3(0.144, 0.042, 0.091);
const vec3 kGel = vec3(0.392, 0.144, 0.122);
const vec3 kDura = vec3(0.791, 0.716, 0.631);
const vec3 kMuscle = vec3(0.270, 0.028, 0.025);
const vec3 kSubcutis = vec3(0.791, 0.571, 0.275);
const vec3 kBlood = vec3(0.195, 0.002, 0.002);
const vec3 kBlanch = vec3(0.815, 0.738, 0.624);
const vec3 kTan = vec3(0.485, 0.275, 0.102);
const vec3 kChar = vec3(0.006, 0.004, 0.003);
const vec3 kVernix = vec3(0.888, 0.839, 0.745);
const vec3 kFascia = vec3(0.738, 0.651, 0.565);
const float kRim = 0.44;  // share that is gone at the edge of what was removed: half, narrow kerfs less

#ifdef SHADOWED
// Share of the light that reaches a place past other tissue. Eight places of the map, each compared
// and blended by the hardware, turned from pixel to pixel.
float light_past_tissue(vec3 p, vec3 n) {
    vec4 seen = light_projection * vec4(p + 0.10 * n, 1.0);
    vec3 at = 0.5 + 0.5 * seen.xyz / seen.w;
    if (at.x < 0.0 || at.y < 0.0 || at.x > 1.0 || at.y > 1.0) return 1.0;
    float turn = 6.2832 * fract(52.9829 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float sum = 0.0;
    for (int i = 0; i < 8; ++i) {
        float a = turn + 2.39996 * float(i), r = 0.0042 * sqrt((float(i) + 0.5) / 8.0);
        sum += texture(light_map, vec3(at.xy + r * vec2(cos(a), sin(a)), at.z));
    }
    return sum / 8.0;
}
#endif

void main() {
    vec2 q = v_rest.xy;
    float depth = v_rest.w, fresh = v_extra.y;
    vec2 uv = (q - map_low) / (map_high - map_low);
    vec4 wound = texture(wound_map, uv);
    vec2 into = 2.0 * (wound.ba - 0.5);        // down the slope of the edge
    vec2 wall = q + depth * vec2(0.28, 0.36);  // steep walls are streaked, as cuts are, not smeared
    vec4 n1 = texture(noise_map, wall / 9.0);
    vec4 n2 = texture(noise_map, wall / 2.3 + vec2(0.37, 0.11));
    vec2 d = texture(border_map, uv).rg;
    d += (n1.rg - 0.5) * vec2(0.7, 1.1) + (n2.rg - 0.5) * 0.35;

    // Columns blend softly: there is no line in the body.
    float w_placode = 1.0 - smoothstep(-0.30, 0.30, d.x);
    float w_skin = smoothstep(-0.45, 0.35, d.y);
    float w_zone = saturate(1.0 - w_placode - w_skin);
    float top = 1.0 - smoothstep(0.10, 0.30, depth);

    // Elements are removed whole. Near the surface the edge of what is gone is therefore taken from
    // the smooth map, not from the triangle; a cut that removed nothing keeps its own.
    float gone = wound.r, by_map = smoothstep(0.02, 0.10, gone) * (1.0 - smoothstep(0.12, 0.34, depth));
    float sharp = max(fwidth(gone), 0.03);
    float seam = max(smoothstep(kRim - sharp, kRim + sharp, gone), 0.5 * smoothstep(0.20, kRim, gone));
    fresh = mix(fresh, seam, by_map);

    vec3 n = normalize(v_normal);
    vec3 v = normalize(eye - v_position);
    if (dot(n, v) < 0.0) n = -n;
    // The skin rolls over into the wound.
    vec3 t = normalize(vec3(1.0, 0.0, 0.0) - n * n.x);
    vec3 b = cross(n, t);
    n = normalize(n + 0.4 * by_map * (t * into.x + b * into.y));
    float nv0 = saturate(dot(n, v));

    vec4 vessels = texture(vessel_map, uv);
    vec4 skin_tex = texture(skin_map, q / skin_tile);
    float away = smoothstep(1.5, 7.0, d.y);

    // --- skin: pink and mottled, thin and red towards the edge
    vec3 skin = kSkin * mix(vec3(0.80, 0.66, 0.64), vec3(1.12, 1.16, 1.15), skin_tex.b);
    skin = mix(skin, skin * vec3(0.98, 0.80, 0.80), 0.8 * (n1.g - 0.35));
    skin *= 0.90 + 0.2 * skin_tex.a;
    skin = mix(kThinEdge * (0.85 + 0.35 * n1.r), skin, smoothstep(-0.2, 3.0, d.y));
    skin = mix(skin, kThinEdge * vec3(0.72, 0.42, 0.42), 0.75 * exp(-sq((d.y - 0.05) / 0.38)));
    skin = mix(skin, kVessel * 1.6, vessels.g * mix(0.50, 0.16, away));
    skin = mix(skin, kVenule * 1.3, vessels.b * mix(0.35, 0.22, away));
    float vernix = skin_tex.r * smoothstep(2.0, 4.0, d.y) * top;
    skin = mix(skin, kVernix, 0.75 * vernix);
    skin = mix(skin, kVernix * vec3(0.95, 0.85, 0.78), 0.28 * skin_tex.g * smoothstep(1.0, 3.0, d.y));
    vec3 dermis = mix(kSkin, kJunction, 0.55) * (0.85 + 0.3 * n2.r);
    skin = mix(skin, dermis, (1.0 - top) * smoothstep(0.05, 0.3, depth));
    vec3 fat = mix(kSubcutis, kSkin, 0.35) * (0.8 + 0.4 * n2.g);
    // Fat is lobules with septa between them; muscle lies under a sheet of fascia.
#ifndef PLAIN
    float septum = 1.0 - smoothstep(0.0, 0.07, abs(n2.g - 0.5));
    fat *= mix(vec3(1.08, 1.06, 1.0), vec3(0.78, 0.52, 0.44), septum);
#endif
    skin = mix(skin, fat, smoothstep(0.65, 0.95, depth + 0.3 * (n1.r - 0.5)));
#ifndef PLAIN
    skin = mix(skin, kFascia * vec3(0.95, 0.80, 0.75), 0.7 * exp(-sq((depth + 0.4 * (n1.r - 0.5) - 1.50) / 0.10)));
#endif
    skin = mix(skin, kMuscle * (0.8 + 0.8 * n2.r), smoothstep(1.45, 1.75, depth + 0.4 * (n1.r - 0.5)));

    // --- zone: a grey-white film over a dark wet space, with fine fibres and vessels
    float fibre = texture(noise_map, vec2(q.x * 0.10 + 0.03 * q.y, q.y * 0.42)).r;
#ifdef PLAIN
    float thin = n1.r;
#else
    float thin = texture(noise_map, q / 14.0 + vec2(0.21, 0.63)).r;
#endif
    vec3 below = mix(vec3(0.20, 0.062, 0.066), vec3(0.095, 0.030, 0.045), saturate(2.2 * n1.g - 0.7));
    float cover = mix(0.20, 0.58, saturate(0.75 * fibre + 0.75 * thin - 0.25));
    cover = mix(cover, 0.92, pow(1.0 - nv0, 3.0));
    cover = mix(cover, 0.75, 0.6 * smoothstep(1.3, 0.2, d.x));
    vec3 film = mix(kMembrane * vec3(0.80, 0.74, 0.73), kJunction * 0.9, 0.35 * smoothstep(1.9, 0.2, d.x) + 0.12);
    vec3 zone = mix(below, film, cover);
    zone = mix(zone, kThinEdge, 0.50 * smoothstep(-1.3, 0.1, d.y));
    zone = mix(zone, kPlacode * 1.3, 0.55 * exp(-sq((d.x - 0.05) / 0.42)));
    zone = mix(zone, kVenule, 0.40 * vessels.b * top);
    zone = mix(zone, kVessel * 1.5, 0.78 * vessels.g * top);
    zone = mix(zone, kGel * (0.55 + 0.5 * n2.r), smoothstep(0.42, 0.62, depth));
    zone = mix(zone, mix(kDura, kGel, 0.45), smoothstep(1.35, 1.7, depth));

    // --- placode: raw, red, a groove with vessels in the midline
    vec3 placode = kPlacode * mix(vec3(0.62, 0.45, 0.50), vec3(1.00, 1.02, 1.05), n1.r);
    placode = mix(placode, kJunction * vec3(0.75, 0.30, 0.27), 0.28 * smoothstep(0.55, 0.85, n2.g));
    float groove = exp(-sq((q.y + 0.25 * (n1.g - 0.5)) / 0.34)) * smoothstep(0.3, -1.2, d.x);
    placode *= 1.0 - 0.55 * groove;
    placode = mix(placode, kVessel * 0.85, 0.82 * vessels.r * top);
    placode = mix(placode, kGel * 0.6, smoothstep(1.1, 1.35, depth));

    vec3 albedo = skin * w_skin + zone * w_zone + placode * w_placode;
    float wet = 0.60 * w_skin + 1.0 * w_zone + 1.0 * w_placode;
    float rough = mix(0.30, 0.20, w_placode + w_zone);
    wet = mix(wet, 0.35, w_skin * vernix);
    wet *= mix(1.0, 0.6 + 0.6 * n1.g, w_skin);

    // --- what was cut open just now bleeds a little and shines; deeper, blood stands darker
    float deep = smoothstep(0.15, 1.1, depth) * fresh;
    vec3 raw = mix(albedo * vec3(0.80, 0.40, 0.38), kBlood * mix(1.9, 0.9, deep) + 0.12 * albedo,
                   0.25 + 0.55 * n2.r);
    // It runs in places and leaves the layers in others.
    float runs = smoothstep(0.30, 0.62, 0.65 * n1.g + 0.35 * n2.r + 0.25 * deep);
    albedo = mix(albedo, raw, fresh * mix(0.45, 0.92, runs));
    wet = mix(wet, 1.0, fresh);

    // --- heat
    float omega = v_damage.x, dried = v_damage.y, charred = v_damage.z;
    float ragged = 0.6 * (n1.g - 0.5) + 0.35 * (n2.r - 0.5);
    // Dose grows tenfold within a tenth of a millimetre: on its logarithm the borders are as soft as
    // in tissue.
    float dose = log2(max(omega, 1e-4)) + 3.0 * ragged;
    albedo = mix(albedo, albedo * vec3(0.80, 0.50, 0.50), 0.7 * smoothstep(-5.0, -2.2, dose) *
                                                          (1.0 - smoothstep(-1.6, 0.2, dose)));
    float blanch = smoothstep(-2.2, 1.4, dose);
    albedo = mix(albedo, mix(kBlanch, film, 0.30) * (0.50 + 0.35 * n2.g) * vec3(1.0, 0.91, 0.83),
                 0.74 * blanch * (1.0 - 0.75 * fresh));
    // Cut walls are seared brown and red, not white: blood cooks into them.
    albedo = mix(albedo, mix(vec3(0.150, 0.042, 0.026), kTan * vec3(0.55, 0.36, 0.34), saturate(2.0 * n1.r - 0.6)), 0.70 * fresh * blanch);
    float tan_part = smoothstep(0.25, 0.90, dried + 0.7 * ragged);
    vec3 seared = mix(kTan, vec3(0.205, 0.062, 0.036), 0.80 * fresh);
    seared *= mix(vec3(1.15, 0.98, 0.84), vec3(0.50, 0.27, 0.22), saturate(2.6 * n1.g - 0.7));
    albedo = mix(albedo, seared * (0.40 + 0.7 * n2.r), mix(0.80, 0.62, fresh) * tan_part);
    albedo *= 1.0 - deep * mix(0.22, 0.45, tan_part);
    // The edge of a kerf is seared hardest: there the steam burst out.
    float edge = by_map * exp(-sq((gone - 0.42) / 0.13));
    albedo = mix(albedo, vec3(0.046, 0.017, 0.010) * (0.7 + 0.9 * n2.r), 0.80 * edge * smoothstep(0.10, 0.45, max(dried, 0.8 * charred)));
    float burnt = smoothstep(0.04, 0.60, charred + 0.6 * ragged * step(0.01, charred));
    albedo = mix(albedo, kChar * (1.0 + 3.5 * n2.g), burnt);
    rough = mix(mix(rough, 0.55, max(blanch, tan_part)), 0.9, burnt);
    wet *= (1.0 - 0.55 * blanch * (1.0 - fresh)) * (1.0 - 0.6 * tan_part) * (1.0 - 0.97 * burnt);

    // --- relief: tissue grain, then the finer and slowly creeping film of amniotic fluid
    float near = smoothstep(70.0, 20.0, length(eye - v_position));
    float grain = (0.55 * w_skin + 0.45 * w_zone + 0.95 * w_placode + 0.8 * fresh + 1.1 * burnt);
    vec2 slope = (n1.ba - 0.5) * grain + (n2.ba - 0.5) * (0.35 * grain + 0.5 * burnt + 0.7 * fresh);
    vec3 nd = normalize(n - t * slope.x - b * slope.y);
#ifdef PLAIN
    vec4 film_noise = n2;
#else
    vec2 drift = vec2(0.011, 0.007) * time_s;
    vec4 film_noise = texture(noise_map, wall / 3.1 + drift);
#endif
    vec2 ripple = slope * 0.75 + (film_noise.ba - 0.5) * mix(0.30, 0.55, near) * (1.0 - 0.45 * w_skin);
    vec3 nf = normalize(n - t * ripple.x - b * ripple.y);

    vec3 la = normalize(light_a - v_position), lb = normalize(light_b - v_position);
    float reach = light_reach(v_position);
    float shade = tool_shade(v_position, n, la);
    // Walls hide the light from the floor between them: the more, the deeper and narrower.
    float between = saturate(0.9 * depth) * (1.0 - smoothstep(0.25, 0.95, wound.g));
    float open = 1.0 - max(0.62 * v_extra.x, mix(0.50, 0.70, fresh) * between);
#ifdef SHADOWED
    shade *= mix(0.30, 1.0, light_past_tissue(v_position, n));
#endif

    // Wrapped diffuse, more for red than for blue: light that has wandered under the surface.
    vec3 wrap = mix(vec3(0.35, 0.12, 0.08), vec3(0.05), burnt);
    float nl = dot(nd, la);
    vec3 diffuse = clamp((nl + wrap) / ((1.0 + wrap) * (1.0 + wrap)), 0.0, 1.0);
    vec3 lit = albedo * diffuse * reach * shade * open;
    // Light that bounces inside the red cavity.
    lit += albedo * vec3(0.055, 0.024, 0.020) * open * (0.35 + 0.65 * min(reach, 1.5));
    // Thin film lets light through from its rim.
    lit += vec3(0.10, 0.035, 0.03) * w_zone * top * (1.0 - burnt) * pow(1.0 - nv0, 2.0) * reach * shade;

    float coat = mix(0.14, 0.24, w_skin) + 0.10 * (n1.r - 0.5);
#ifdef PLAIN
    float spec = wet * highlight(nf, v, normalize(la + lb), 1.2 * sq(coat), 0.028);
#else
    float spec = wet * (highlight(nf, v, la, sq(coat), 0.028) + highlight(nf, v, lb, sq(coat), 0.028)) * 0.5;
#endif
    spec += 0.5 * highlight(nd, v, la, sq(rough + 0.12), 0.04);
    spec = min(spec, 18.0);
    colour = vec4(lit + spec * reach * shade * open * vec3(1.0, 0.985, 0.96), 1.0);
}
