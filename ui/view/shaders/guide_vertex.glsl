layout(location = 0) in vec4 point;  // xyz [mm], kind: 0 planned, 1 = cut already, 2 = ink
uniform mat4 view_projection;
uniform float point_size;
out float v_kind;
void main() {
    v_kind = point.w;
    gl_Position = view_projection * vec4(point.xyz, 1.0);
    gl_PointSize = point_size;
}
