// From the linear picture to what the camera's monitor shows: lens, haze, bloom, curve, sensor.
// Programs of one text, for a software renderer computes every branch of a shader for every pixel: a
// clean lens; WET, with what can lie on the lens; PLAIN, the least that is needed; each also SMOOTH,
// with softened steps at edges.
in vec2 v_uv;
uniform sampler2D picture;
uniform sampler2D bloom;
uniform sampler2D exposure_map;
uniform vec2 window_px;
uniform vec2 circle_centre;  // [px]
uniform float circle_radius;
uniform float haze;       // 0 clear .. 1 white-out
uniform float noise_seed;
uniform float dim;        // 1 = normal, < 1 behind the menu
uniform vec4 drops[10];   // on the lens: place in the circle, radius, strength
uniform int drop_count;
uniform float lens_fog;   // 0 clear .. 0.8
uniform float cloth;      // edge of the wiping cloth, 2 = none
out vec4 colour;

const float kBarrel1 = 0.20, kBarrel2 = 0.03, kRim = 1.0 + kBarrel1 + kBarrel2;
const vec3 kSurround = vec3(0.0045, 0.0050, 0.0058);  // also in post_process.cpp

vec2 undistort(vec2 p) {
    float r2 = dot(p, p);
    return p * (1.0 + kBarrel1 * r2 + kBarrel2 * r2 * r2) / kRim;
}
// Filmic curve. Source: K. Narkowicz, "ACES filmic tone mapping curve".
vec3 film(vec3 x) { return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }
vec3 encode(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233)) + noise_seed) * 43758.5453); }

#ifdef SMOOTH
uniform vec2 texel;

float tone(vec4 c) { return c.g / (c.g + 0.4); }
// Looks for an edge and blends along it, where an instrument (alpha 0) meets what is behind it:
// highlights of the wet surface stay the points that they are. Source: T. Lottes 2011, "FXAA".
vec3 smoothed(vec2 at) {
    vec2 h = 0.5 * texel;
    vec4 c = texture(picture, at);
    vec4 c_nw = texture(picture, at + vec2(-h.x, h.y)), c_ne = texture(picture, at + h);
    vec4 c_sw = texture(picture, at - h), c_se = texture(picture, at + vec2(h.x, -h.y));
    float nw = tone(c_nw), ne = tone(c_ne), sw = tone(c_sw), se = tone(c_se), m = tone(c);
    float share = 0.25 * (c_nw.a + c_ne.a + c_sw.a + c_se.a);
    float low = min(m, min(min(nw, ne), min(sw, se))), high = max(m, max(max(nw, ne), max(sw, se)));
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    float weak = max(0.03125 * (nw + ne + sw + se), 1.0 / 128.0);
    along *= 1.0 / (min(abs(along.x), abs(along.y)) + weak);
    along = clamp(along, -8.0, 8.0) * texel;
    vec4 near = 0.5 * (texture(picture, at - along / 6.0) + texture(picture, at + along / 6.0));
    vec4 far = 0.5 * near + 0.25 * (texture(picture, at - 0.5 * along) + texture(picture, at + 0.5 * along));
    float t = tone(far);
    vec4 blended = t < low || t > high ? near : far;
    return mix(c, blended, step(0.02, share) * step(share, 0.98)).rgb;
}
#else
vec3 smoothed(vec2 at) { return texture(picture, at).rgb; }
#endif

void main() {
    vec2 px = v_uv * window_px;
    vec2 p = (px - circle_centre) / circle_radius;
    float r = length(p);
    float inside = 1.0 - smoothstep(1.0 - 2.0 / circle_radius, 1.0, r);
    vec2 seen = p;
#ifdef WET
    // Droplets are small lenses: they show the field small and upside down, bright at one rim.
    float glint = 0.0, wet = 0.0;
    for (int i = 0; i < drop_count; ++i) {
        vec2 d = p - drops[i].xy;
        float q = length(d) / drops[i].z;
        if (q >= 1.0) continue;
        float k = drops[i].w * smoothstep(1.0, 0.8, q);
        seen = mix(seen, drops[i].xy - d * (2.5 + 2.0 * q * q), k);
        glint += k * smoothstep(0.55, 0.95, q) * smoothstep(-0.2, 0.9, dot(d / drops[i].z, vec2(-0.5, 0.8)));
        wet = max(wet, k * smoothstep(0.6, 1.0, q));
    }
#endif
    vec2 u = undistort(seen);
#if defined(PLAIN) || defined(SMOOTH)
    vec3 c = smoothed(0.5 + 0.5 * u);
#else
    // The colours part by about one pixel at the rim.
    vec2 shift = p * r * (1.0 / circle_radius);
    vec3 c;
    c.r = texture(picture, 0.5 + 0.5 * (u + shift)).r;
    c.g = texture(picture, 0.5 + 0.5 * u).g;
    c.b = texture(picture, 0.5 + 0.5 * (u - shift)).b;
#endif
    // Fog: every point smears over its surroundings, and the light of the scope comes back white.
    bool wiped = cloth < 1.5 && p.x < cloth;
    float fogged = wiped ? 0.0 : lens_fog;
#ifdef WET
    if (fogged > 0.01) {
        float reach = 0.012 + 0.05 * fogged;
        vec3 smear = vec3(0.0);
        for (int i = 0; i < 8; ++i) {
            float a = 0.785398 * float(i) + 6.2832 * hash(px);
            vec2 o = reach * (0.4 + 0.6 * fract(float(i) * 0.618)) * vec2(cos(a), sin(a));
            smear += texture(picture, 0.5 + 0.5 * (u + o)).rgb;
        }
        c = mix(c, smear / 8.0, min(1.0, 1.6 * fogged));
    }
#endif
    float exposure = texture(exposure_map, vec2(0.5)).r;
    c *= exposure;
#ifndef PLAIN
    c += 0.38 * texture(bloom, 0.5 + 0.5 * u).rgb;
#endif
    // Smoke that has gathered: light thrown back at the lens, brightest in the middle.
    vec3 fog = vec3(0.485, 0.456, 0.423) * mix(0.85, 0.55, r);
    c = mix(c, fog, haze);
#ifndef PLAIN
    c = mix(c, vec3(0.34, 0.33, 0.32), 0.55 * fogged);
#else
    c = mix(c, vec3(0.34, 0.33, 0.32), 0.80 * fogged);  // no smear here: as much is lost
#endif
#ifdef WET
    c = c * (1.0 - 0.35 * wet) + 0.5 * glint;
    if (cloth < 1.5) {  // a strip of white gauze passes
        float strip = smoothstep(0.40, 0.30, abs(p.x - cloth - 0.2 + 0.03 * sin(11.0 * p.y)));
        float weave = 0.5 + 0.06 * sin(140.0 * p.x) * sin(140.0 * p.y);
        c = mix(c, vec3(weave), strip);
    }
#endif
    c *= (1.0 - 0.38 * r * r) * (1.0 - smoothstep(0.93, 1.0, r));
    c = film(c * 0.95);
#ifndef PLAIN
    float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
    float grain = hash(px) + hash(px + 17.3) - 1.0;
    c += grain * mix(0.016, 0.004, sqrt(luminance)) * sqrt(luminance + 0.02);
#endif
    c = encode(clamp(c, 0.0, 1.0));
    colour = vec4(mix(encode(kSurround), c, inside) * dim, 1.0);
}
