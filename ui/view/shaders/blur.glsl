in vec2 v_uv;
uniform sampler2D picture;
uniform vec2 direction;  // one texel along the axis
out vec4 colour;
void main() {
    vec3 c = texture(picture, v_uv).rgb * 0.227;
    c += (texture(picture, v_uv + direction * 1.385).rgb + texture(picture, v_uv - direction * 1.385).rgb) * 0.316;
    c += (texture(picture, v_uv + direction * 3.231).rgb + texture(picture, v_uv - direction * 3.231).rgb) * 0.070;
    colour = vec4(c, 1.0);
}
