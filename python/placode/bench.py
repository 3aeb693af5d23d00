# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package costs; `placodectl bench environment` runs it: TASK SCENE_JSON RUNS.

The same 2 s of the scripted expert at work as the C++ side measures, in steps of 20 frames; once
more with a picture after every step where there is OpenGL.
"""

import json
import statistics
import sys
import time

import numpy as np

import placode

FRAMES, BEGIN_STEPS, STEPS = 20, 200, 100


def work(env):
    """The moment before, and the expert's actions from then on."""
    expert = placode.policies.Scripted(env, "expert")
    observation, _ = env.reset(seed=1)
    actions, moment = [], None
    for i in range(BEGIN_STEPS + STEPS):
        if i == BEGIN_STEPS:
            moment = env.save()
        actions.append(expert(observation))
        observation, _, terminated, truncated, _ = env.step(actions[-1])
        if terminated or truncated:
            break
    return moment, actions[BEGIN_STEPS:]


def call_us(env):
    """A step of one frame as Gymnasium's interface gives it, less the same without Python's part."""
    env.reset(seed=1)
    action = env.actions.part(env.actions.rest)
    full, out = env.actions.rest.copy(), np.empty(env.observation_space.shape)
    env.frame_skip = 1
    for _ in range(300):
        env.step(action)
    both = []
    for _ in range(15):
        start = time.perf_counter()
        for _ in range(100):
            env.step(action)
        middle = time.perf_counter()
        for _ in range(100):
            env.handle.step(full, 1, False)
            env.handle.observe(out)
        both.append((middle - start) - (time.perf_counter() - middle))
    env.frame_skip = FRAMES
    return 1e6 * max(0.0, statistics.median(both)) / 100


def frames_per_s(env, moment, actions, runs):
    """Median over the runs; with a picture after every step where the environment draws."""
    times = []
    for _ in range(runs):
        env.restore(moment)
        env.render()
        start = time.perf_counter()
        for action in actions:
            env.step(action)
            env.render()
        times.append(time.perf_counter() - start)
    return len(actions) * FRAMES / statistics.median(times)


def main(task, scene, runs):
    options = {"units": "absolute", "lesions": 1, "frame_skip": FRAMES,
               "scene": json.loads(scene) if scene else None}
    env = placode.make(task, **options)
    moment, actions = work(env)
    figures = {"frames_per_s": frames_per_s(env, moment, actions, runs), "call_us": call_us(env)}
    drawing = placode.make(task, render_mode="rgb_array", **options)
    try:
        figures["pictured_frames_per_s"] = frames_per_s(drawing, moment, actions, min(runs, 3))
        figures["picture"] = drawing.render().shape[1::-1]
    except placode.errors.NoPicture:
        pass  # no OpenGL here
    print(json.dumps(figures))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
