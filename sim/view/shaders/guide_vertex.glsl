layout(location = 0) in vec4 point;  // xyz [mm], 1 = already cut
uniform mat4 view_projection;
uniform float point_size;
out float v_cut;
void main() {
    v_cut = point.w;
    gl_Position = view_projection * vec4(point.xyz, 1.0);
    gl_PointSize = point_size;
}
