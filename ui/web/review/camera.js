// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the picture is seen from.

import {add, cross, dot, turned, unit} from "./vector.js";

export const VIEWS = {above: [-0.25, 0, 1], side: [-0.6, -1, 0.6]};

export class Camera {
  constructor() {
    this.target = [0, 0, 0];
    this.look("above");
  }
  look(view) {
    const from = unit(VIEWS[view] || [-0.6, 0, 0.8]);
    this.turn = Math.atan2(from[1], from[0]);
    this.rise = Math.asin(from[2]);
    this.distance = 62;
  }
  turnBy(sideways, upwards) {
    this.turn -= sideways;
    this.rise = Math.min(1.55, Math.max(-0.3, this.rise + upwards));
  }
  nearer(factor) {
    this.distance = Math.min(250, Math.max(8, this.distance * factor));
  }
  orbit() {
    const from = [Math.cos(this.rise) * Math.cos(this.turn),
                  Math.cos(this.rise) * Math.sin(this.turn), Math.sin(this.rise)];
    const forward = from.map((c) => -c), right = unit(cross(forward, [0, 0, 1]));
    return {eye: add(this.target, from, this.distance), forward, right,
            up: cross(right, forward), half: 0.42};
  }
  // The fetoscope: x right, y down, z into the picture; an oblique optic looks down past its axis.
  static scope(spec, state) {
    const a = -spec.scope_angle_deg * Math.PI / 360, q = state.slice(3, 7);
    const seen = (v) => turned(q, turned([Math.cos(a), Math.sin(a), 0, 0], v));
    return {eye: state.slice(0, 3).map((c) => 1000 * c), forward: seen([0, 0, 1]),
            right: seen([1, 0, 0]), up: seen([0, -1, 0]),
            half: spec.field_of_view_deg * Math.PI / 360};
  }
}

// Column by column. The half angle belongs to the shorter side of the picture.
export const projection = (camera, aspect) => {
  const f = 1 / Math.tan(camera.half), near = 1, far = 400;
  const fx = aspect > 1 ? f / aspect : f, fy = aspect > 1 ? f : f * aspect;
  const {right: r, up: u, forward: w, eye: e} = camera;
  const rows = [[...r, -dot(r, e)].map((c) => fx * c), [...u, -dot(u, e)].map((c) => fy * c),
                [...w, -dot(w, e)].map((c) => c * (far + near) / (far - near)),
                [...w, -dot(w, e)]];
  rows[2][3] -= 2 * far * near / (far - near);
  return new Float32Array([0, 1, 2, 3].flatMap((c) => rows.map((row) => row[c])));
};
