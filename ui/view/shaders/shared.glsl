// Put before every fragment shader: light at the scope, wet film, shadow of the instruments.
// Lengths in mm, W frame, linear RGB.
uniform vec3 eye;          // camera
uniform vec3 view_axis;    // into the picture
uniform vec3 light_a;      // the fibre ring around the lens, as two sources
uniform vec3 light_b;
uniform float cone_cos;    // cosine of the edge of the light cone
uniform float time_s;
uniform vec4 capsule_a[6];  // xyz, radius
uniform vec4 capsule_b[6];
uniform int capsule_count;

float sq(float x) { return x * x; }
float saturate(float x) { return clamp(x, 0.0, 1.0); }

// Soft shadow of a capsule on the way to the light. Source: I. Quilez, "capsule - soft shadow".
float capsule_shadow(vec3 origin, vec3 dir, vec3 a, vec3 b, float r, float k) {
    vec3 ba = b - a, oa = origin - a;
    float oad = dot(oa, dir), dba = dot(dir, ba), baba = dot(ba, ba), oaba = dot(oa, ba);
    vec2 th = vec2(-oad * baba + dba * oaba, oaba - oad * dba) / max(baba - dba * dba, 1e-4);
    th.x = max(th.x, 1e-3);
    th.y = clamp(th.y, 0.0, 1.0);
    float d = length(a + ba * th.y - origin - dir * th.x) - r;
    return smoothstep(0.0, 1.0, k * d / th.x + 0.5);
}

// Shadow of the tools and the darkness right below them.
float tool_shade(vec3 p, vec3 n, vec3 to_light) {
    float shade = 1.0;
    for (int i = 0; i < capsule_count; ++i) {
        vec3 a = capsule_a[i].xyz, b = capsule_b[i].xyz;
        float r = capsule_a[i].w;
        shade *= mix(0.16, 1.0, capsule_shadow(p + 0.05 * n, to_light, a, b, r, 6.0));
        vec3 ba = b - a;
        float h = clamp(dot(p - a, ba) / dot(ba, ba), 0.0, 1.0);
        vec3 d = a + h * ba - p;
        float l = max(length(d), r);
        shade *= 1.0 - 0.55 * saturate(0.25 + 0.75 * dot(n, d) / l) * sq(r / l);
    }
    return shade;
}

float light_reach(vec3 p) {
    vec3 l = eye - p;
    float d = max(length(l), 5.0);
    float c = dot(-l / d, view_axis);
    return 625.0 / (d * d) * smoothstep(cone_cos - 0.10, cone_cos + 0.09, c);
}

float ggx(float nh, float a) {
    float t = nh * nh * (a * a - 1.0) + 1.0;
    return a * a / (3.14159265 * t * t);
}

// Highlight of one source; a = roughness squared, f0 = reflectance at normal incidence.
float highlight(vec3 n, vec3 v, vec3 l, float a, float f0) {
    vec3 h = normalize(v + l);
    float nl = saturate(dot(n, l)), nv = max(dot(n, v), 0.05);
    float f = f0 + (1.0 - f0) * pow(1.0 - saturate(dot(h, v)), 5.0);
    float k = 0.5 * a;
    float g = 0.25 / ((nl * (1.0 - k) + k) * (nv * (1.0 - k) + k));
    return ggx(saturate(dot(n, h)), a) * f * g * nl;
}
