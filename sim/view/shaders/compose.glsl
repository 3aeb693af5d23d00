// From the linear picture to what the camera's monitor shows: lens, haze, bloom, curve, sensor.
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
out vec4 colour;

const float kBarrel1 = 0.20, kBarrel2 = 0.03, kRim = 1.0 + kBarrel1 + kBarrel2;

vec2 undistort(vec2 p) {
    float r2 = dot(p, p);
    return p * (1.0 + kBarrel1 * r2 + kBarrel2 * r2 * r2) / kRim;
}
// Filmic curve. Source: K. Narkowicz, "ACES filmic tone mapping curve".
vec3 film(vec3 x) { return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0); }
vec3 encode(vec3 c) { return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
float hash(vec2 p) { return fract(sin(dot(p, vec2(12.9898, 78.233)) + noise_seed) * 43758.5453); }

void main() {
    vec2 px = v_uv * window_px;
    vec2 p = (px - circle_centre) / circle_radius;
    float r = length(p);
    vec3 surround = vec3(0.0045, 0.0050, 0.0058);
    float inside = 1.0 - smoothstep(1.0 - 2.0 / circle_radius, 1.0, r);
    if (inside <= 0.0) {
        colour = vec4(encode(surround) * dim, 1.0);
        return;
    }
    // The colours part by about one pixel at the rim.
    vec2 u = undistort(p), shift = p * r * (1.0 / circle_radius);
    vec3 c;
    c.r = texture(picture, 0.5 + 0.5 * (u + shift)).r;
    c.g = texture(picture, 0.5 + 0.5 * u).g;
    c.b = texture(picture, 0.5 + 0.5 * (u - shift)).b;
    float exposure = texture(exposure_map, vec2(0.5)).r;
    c *= exposure;
    c += 0.38 * texture(bloom, 0.5 + 0.5 * u).rgb;
    // Smoke that has gathered: light thrown back at the lens, brightest in the middle.
    vec3 fog = vec3(0.485, 0.456, 0.423) * mix(0.85, 0.55, r);
    c = mix(c, fog, haze);
    c *= (1.0 - 0.38 * r * r) * (1.0 - smoothstep(0.93, 1.0, r));
    c = film(c * 0.95);
    float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
    float grain = hash(px) + hash(px + 17.3) - 1.0;
    c += grain * mix(0.016, 0.004, sqrt(luminance)) * sqrt(luminance + 0.02);
    c = encode(clamp(c, 0.0, 1.0));
    colour = vec4(mix(encode(surround), c, inside) * dim, 1.0);
}
