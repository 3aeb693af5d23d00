layout(location = 0) in vec4 corner;  // x y [px, y down], u v
layout(location = 1) in vec4 tint;
layout(location = 2) in vec2 kind;    // 0 text, 1 box, 2 ring; parameter
uniform vec2 window_px;
out vec2 v_uv;
out vec4 v_tint;
out vec2 v_kind;
void main() {
    v_uv = corner.zw;
    v_tint = tint;
    v_kind = kind;
    gl_Position = vec4(corner.x / window_px.x * 2.0 - 1.0, 1.0 - corner.y / window_px.y * 2.0, 0.0, 1.0);
}
