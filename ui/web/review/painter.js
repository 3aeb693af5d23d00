// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// WebGL 2: one program for everything.

import {projection} from "./camera.js";

const VERTEX = `#version 300 es
uniform mat4 see;
uniform float dot_px;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
out vec3 at, facing, tone;
void main() {
  gl_Position = see * vec4(place, 1.0);
  gl_PointSize = dot_px;
  at = place;
  facing = normal;
  tone = colour;
}`;
// A light beside the lens, a little from all around, and the shine of wet tissue.
const FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 eye;
uniform float lit;
in vec3 at, facing, tone;
out vec4 seen;
void main() {
  vec3 v = normalize(eye - at), n = normalize(facing);
  if (dot(n, v) < 0.0) n = -n;
  float facing_light = max(dot(n, v), 0.0), shine = pow(facing_light, 60.0);
  vec3 linear = mix(tone, tone * (0.22 + 0.85 * facing_light) + 0.16 * shine, lit);
  seen = vec4(pow(clamp(linear, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
}`;

export class Painter {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = this.gl = canvas.getContext("webgl2", {antialias: true, alpha: false});
    if (!gl) throw new Error("no WebGL 2");
    const program = this.program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
      throw new Error(gl.getProgramInfoLog(program));
    gl.useProgram(program);
    this.place = Object.fromEntries(["see", "dot_px", "eye", "lit"].map(
        (name) => [name, gl.getUniformLocation(program, name)]));
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    for (let i = 0; i < 3; ++i) {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, 3, gl.FLOAT, false, 36, 12 * i);
    }
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0.10, 0.035, 0.03, 1);
  }

  begin(camera) {
    const {gl, canvas} = this, ratio = window.devicePixelRatio || 1;
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
    const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) {
      canvas.width = width;
      canvas.height = height;
    }
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.place.see, false, projection(camera, width / height));
    gl.uniform3fv(this.place.eye, camera.eye);
    gl.uniform1f(this.place.dot_px, 4 * ratio);
  }

  draw(soup, kind, lit) {
    const {gl} = this;
    gl.uniform1f(this.place.lit, lit);
    gl.bufferData(gl.ARRAY_BUFFER, soup.data.subarray(0, soup.used), gl.STREAM_DRAW);
    gl.drawArrays(kind, 0, soup.used / 9);
  }
}
