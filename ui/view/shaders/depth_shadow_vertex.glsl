layout(location = 0) in vec3 position;
layout(location = 1) in float share;
uniform mat4 view_projection;
out vec3 v_position;
out float v_share;
void main() {
    v_position = position;
    v_share = share;
    gl_Position = view_projection * vec4(position, 1.0);
}
