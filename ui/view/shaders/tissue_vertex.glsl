layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 rest;    // xyz, depth below the rest surface [mm]
layout(location = 3) in vec4 damage;  // blanch, dried, charred, temperature [C]
layout(location = 4) in vec2 extra;   // hollow (0 open .. 1 deep), fresh
uniform mat4 view_projection;
out vec3 v_position;
out vec3 v_normal;
out vec4 v_rest;
out vec4 v_damage;
out vec2 v_extra;
void main() {
    v_position = position;
    v_normal = normal;
    v_rest = rest;
    v_damage = damage;
    v_extra = extra;
    gl_Position = view_projection * vec4(position, 1.0);
}
