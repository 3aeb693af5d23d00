layout(location = 0) in vec3 position;
uniform mat4 view_projection;
out vec3 v_position;
void main() {
    v_position = position;
    gl_Position = view_projection * vec4(position, 1.0);
}
