layout(location = 0) in vec4 particle;  // centre [mm], radius [mm]
layout(location = 1) in vec2 look;      // opacity, seed
uniform mat4 view_projection;
uniform vec3 camera_right;
uniform vec3 camera_up;
out vec2 v_corner;
out vec2 v_look;
out vec3 v_position;
const vec2 kCorner[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
void main() {
    v_corner = kCorner[gl_VertexID % 6];
    v_look = look;
    v_position = particle.xyz + particle.w * (v_corner.x * camera_right + v_corner.y * camera_up);
    gl_Position = view_projection * vec4(v_position, 1.0);
}
