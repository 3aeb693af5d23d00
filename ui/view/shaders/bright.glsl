// Quarter-size picture for bloom (rgb above white) and metering (alpha = log luminance).
in vec2 v_uv;
uniform sampler2D picture;
uniform sampler2D exposure_map;
uniform vec2 texel;
out vec4 colour;
void main() {
    vec3 c = texture(picture, v_uv + texel * vec2(-0.5, -0.5)).rgb + texture(picture, v_uv + texel * vec2(0.5, -0.5)).rgb +
             texture(picture, v_uv + texel * vec2(-0.5, 0.5)).rgb + texture(picture, v_uv + texel * vec2(0.5, 0.5)).rgb;
    c = min(0.25 * c, vec3(24.0));
    float luminance = dot(c, vec3(0.2126, 0.7152, 0.0722));
    vec3 exposed = c * texture(exposure_map, vec2(0.5)).r;
    float over = max(max(exposed.r, max(exposed.g, exposed.b)) - 1.0, 0.0);
    colour = vec4(exposed * over / (over + 1.0) , log2(max(luminance, 1e-3)));
}
