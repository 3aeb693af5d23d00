// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The review of an attempt: fetches its track part by part and shows it.

import {Camera, VIEWS} from "./camera.js";
import {Painter} from "./painter.js";
import {drawNeedle, drawThread} from "./needle.js";
import {FLOATS_OF_TOOL, Part} from "./part.js";
import {Soup} from "./soup.js";
import {TissueSoup} from "./tissue.js";
import {drawTool, ENGAGED} from "./tools.js";
import {add, unit} from "./vector.js";

const PARTS_KEPT = 8;
const CUT = 1, MARKED = 2;  // flags of a point of a line

const clock = (seconds) => {
  const whole = Math.floor(seconds + 1e-6);
  return Math.floor(whole / 60) + ":" + String(whole % 60).padStart(2, "0");
};

class Review {
  constructor(root) {
    this.root = root;
    const one = (name) => document.getElementById("review-" + name);
    Object.assign(this, {said: one("said"), canvas: one("picture"), button: one("play"),
                         slider: one("time"), clock: one("clock"), view: one("camera"),
                         speed: one("speed")});
    this.parts = new Map();  // number -> promise; the most lately used last
    this.camera = new Camera();
    this.time = 0;
    this.playing = false;
    this.dirty = true;
    this.extra = new Soup();
  }

  say(words) {
    this.said.textContent = words;
    this.said.hidden = words === "";
  }

  async start() {
    try {
      this.painter = new Painter(this.canvas);
      if (!window.DecompressionStream) throw new Error("no DecompressionStream");
    } catch (error) {
      this.say(this.root.dataset.old);
      return;
    }
    try {
      const answer = await this.fetched(this.root.dataset.track);
      this.head = await answer.json();
    } catch (error) {
      this.say(this.root.dataset.lost);
      return;
    }
    this.tissue = new TissueSoup(this.head);
    this.slider.max = this.head.until_s;
    this.speed.value = "1";
    this.listen();
    this.fromAddress();
    let last = performance.now();
    const turn = (now) => {
      this.tick(Math.min(0.25, (now - last) / 1000));
      last = now;
      requestAnimationFrame(turn);
    };
    requestAnimationFrame(turn);
  }

  // #t=12.5 leads to a moment.
  fromAddress() {
    const wanted = /^#t=([0-9]+(\.[0-9]+)?)$/.exec(location.hash);
    if (wanted) this.go(parseFloat(wanted[1]));
  }

  async fetched(address) {
    const answer = await fetch(address, {redirect: "error", credentials: "same-origin"});
    if (!answer.ok) throw new Error(address + ": " + answer.status);
    return answer;
  }

  part(number) {
    let found = this.parts.get(number);
    if (found) {
      this.parts.delete(number);
    } else {
      found = {part: null};
      found.ready = this.fetched(this.root.dataset.part + number)
          .then((answer) => new Response(answer.body.pipeThrough(
              new DecompressionStream("deflate"))).arrayBuffer())
          .then((buffer) => {
            found.part = new Part(buffer);
            this.dirty = true;
          })
          .catch(() => {
            this.parts.delete(number);
            this.pause();
            this.say(this.root.dataset.lost);
          });
    }
    this.parts.set(number, found);
    if (this.parts.size > PARTS_KEPT) this.parts.delete(this.parts.keys().next().value);
    return found.part;
  }

  pause() {
    this.playing = false;
    this.button.textContent = this.root.dataset.play;
  }

  play() {
    if (this.time >= this.head.until_s - 0.05) this.time = 0;
    this.playing = true;
    this.button.textContent = this.root.dataset.pause;
  }

  go(seconds) {
    this.time = Math.min(this.head.until_s, Math.max(0, seconds));
    this.dirty = true;
  }

  tick(elapsed) {
    const picture = Math.min(this.head.pictures - 1,
                             Math.floor(this.time * this.head.pictures_per_s));
    if (picture < 0) return;
    const number = Math.floor(picture / this.head.pictures_of_part);
    const part = this.part(number);
    if (!part) return;  // the clock waits for what is fetched
    if (number + 1 < this.head.parts && this.playing) this.part(number + 1);
    if (this.playing) {
      this.go(this.time + elapsed * parseFloat(this.speed.value));
      if (this.time >= this.head.until_s) this.pause();
    }
    const resized = this.canvas.clientWidth !== this.width;
    this.width = this.canvas.clientWidth;
    if (!this.dirty && !resized) return;
    this.dirty = false;
    const within = Math.min(part.pictures - 1, picture - number * this.head.pictures_of_part);
    part.go(within);
    this.draw(part, within);
    this.slider.value = this.time;
    this.clock.textContent = clock(this.time) + " / " + clock(this.head.until_s);
    this.slider.setAttribute("aria-valuetext", this.clock.textContent);
  }

  cameraOf(states) {
    const scope = this.head.tools.findIndex((tool) => tool.kind === "scope");
    if (this.view.value !== "scope" || scope < 0) return this.camera.orbit();
    const state = states[scope];
    // Before anybody held the scope it has no place.
    return Math.hypot(...state.slice(0, 3)) < 1e-6 ? this.camera.orbit()
                                                    : Camera.scope(this.head.tools[scope], state);
  }

  draw(part, picture) {
    const states = this.head.tools.map((_, i) => {
      const from = (picture * part.tools + i) * FLOATS_OF_TOOL;
      return Array.from(part.toolStates.subarray(from, from + FLOATS_OF_TOOL));
    });
    const {gl} = this.painter, camera = this.cameraOf(states);
    this.painter.begin(camera);
    this.painter.draw(this.tissue.build(part), gl.TRIANGLES, 1);
    this.extra.clear();
    this.head.tools.forEach((spec, i) => {
      const flags = part.toolFlags[picture * part.tools + i];
      if (spec.kind === "scope" || (spec.shares_hand && !(flags & ENGAGED))) return;
      drawTool(this.extra, spec, states[i], flags);
    });
    const needle = part.needleAt(picture);
    if (needle && this.head.needle) {
      drawNeedle(this.extra, this.head.needle, needle);
      drawThread(this.extra, part.threadAt(picture).map((p) => p.map((c) => this.placeMm(c))));
    }
    this.painter.draw(this.extra, gl.TRIANGLES, 1);
    this.drawPlan(part, picture, camera);
  }

  placeMm(steps) {
    return 1000 * (this.head.least_m + this.head.step_m * steps);
  }

  // The planned line and that around marked tissue, a little before what they lie on.
  drawPlan(part, picture, camera) {
    this.extra.clear();
    this.extra.room(part.points);
    for (let i = 0; i < part.points; ++i) {
      const p = [0, 1, 2].map((a) => this.placeMm(part.x[a * part.places + part.vertices + i]));
      const flags = part.pointFlags[picture * part.points + i];
      // Where it is cut the wound shows it, and a point may have gone with a piece.
      if (flags & CUT) continue;
      this.extra.corner(add(p, unit(add(camera.eye, p, -1)), 0.15), [0, 0, 1],
                        flags & MARKED ? [0.80, 0.55, 0.05] : [0.05, 0.12, 0.75]);
    }
    this.painter.draw(this.extra, this.painter.gl.POINTS, 0);
  }

  listen() {
    const redraw = () => { this.dirty = true; };
    this.button.addEventListener("click", () => (this.playing ? this.pause() : this.play()));
    this.slider.addEventListener("input", () => this.go(parseFloat(this.slider.value)));
    this.view.addEventListener("change", () => {
      if (this.view.value in VIEWS) this.camera.look(this.view.value);
      redraw();
    });
    window.addEventListener("resize", redraw);
    window.addEventListener("hashchange", () => this.fromAddress());
    for (const button of document.querySelectorAll(".moment"))
      button.addEventListener("click", () => {
        this.pause();
        this.go(parseInt(button.dataset.time, 10) / 1000);
        this.canvas.scrollIntoView({block: "nearest"});
      });
    this.listenToPointers();
    this.canvas.addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1],
                   ArrowDown: [0, -0.1]};
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key in turns) this.moved(() => this.camera.turnBy(...turns[event.key]));
    else if (event.key === "+") this.moved(() => this.camera.nearer(0.9));
    else if (event.key === "-") this.moved(() => this.camera.nearer(1 / 0.9));
    else if (event.key === " ") this.playing ? this.pause() : this.play();
    else return;
    event.preventDefault();
  }

  // Whoever turns the picture has a camera of their own.
  moved(change) {
    this.view.value = "free";
    change();
    this.dirty = true;
  }

  listenToPointers() {
    const down = new Map();  // pointer -> place
    const spread = () => {
      const [a, b] = [...down.values()];
      return Math.hypot(a[0] - b[0], a[1] - b[1]) || 1;
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      down.set(event.pointerId, [event.clientX, event.clientY]);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      const before = down.get(event.pointerId);
      if (!before) return;
      const wide = down.size === 2 ? spread() : 0;
      down.set(event.pointerId, [event.clientX, event.clientY]);
      if (wide > 0) this.moved(() => this.camera.nearer(wide / spread()));
      else if (down.size === 1)
        this.moved(() => this.camera.turnBy(0.008 * (event.clientX - before[0]),
                                            0.008 * (event.clientY - before[1])));
    });
    for (const name of ["pointerup", "pointercancel"])
      this.canvas.addEventListener(name, (event) => down.delete(event.pointerId));
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.moved(() => this.camera.nearer(Math.exp(0.001 * event.deltaY)));
    }, {passive: false});
  }
}

const root = document.getElementById("review");
if (root) new Review(root).start();
