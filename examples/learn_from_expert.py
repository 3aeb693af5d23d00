#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Learns a task from a scripted expert in minutes: behaviour cloning with numpy alone.

PYTHONPATH=build/release/python /usr/bin/python3 examples/learn_from_expert.py [TASK] [DEMONSTRATIONS] [EPOCHS] [ATTEMPTS] [FILE]
Four networks of two layers predict the next 15 actions (0.3 s); the mean of their predictions is done
before they look again. Who looks at every step stops where the expert waits; samples in which the
expert only waits are left out for the same reason. One network alone learns the bite in one training
of four; four together learn it. The reward on three attempts of its own chooses the epoch;
the attempts that are reported have seeds that nothing was chosen by. FILE.placode: the last of them.
"""
import sys

import numpy as np

import placode

TASK = sys.argv[1] if len(sys.argv) > 1 else "Placode/Bite-v0"
DEMONSTRATIONS = int(sys.argv[2]) if len(sys.argv) > 2 else 24
EPOCHS = int(sys.argv[3]) if len(sys.argv) > 3 else 12
ATTEMPTS = int(sys.argv[4]) if len(sys.argv) > 4 else 10
AHEAD, WIDTH, TOGETHER, STEPS = 15, 128, 4, 1000
CHOOSING, TESTING = range(100, 100 + min(3, ATTEMPTS)), range(200, 200 + ATTEMPTS)
# Every seed has a lesion of its own: those of the reported attempts were never seen.
env = placode.make(TASK, scene=placode.COARSE, lesions=0, units="absolute", finish_action=True, record=True).unwrapped
at, did = env.observation_names.index, env.action_names.index
# Actions are learned in mm and tenths of a radian, places and rolls from where the instrument is.
AXES = {".x": 1000, ".y": 1000, ".z": 1000, ".roll": 10, ".jaw": 10}
UNIT = np.array([AXES.get(name[name.find("."):], 1) for name in env.action_names])
FROM = [(did(f"tool{i}.{axis}"), at(f"tool{i}.{seen}"), scale) for i in range(len(env.handle.tools))
        for axis, seen, scale in (("x", "tip_x_mm", 1e-3), ("y", "tip_y_mm", 1e-3), ("z", "tip_z_mm", 1e-3),
                                  ("roll", "roll_rad", 1)) if f"tool{i}.{axis}" in env.action_names]
GOALS = [i for i, name in enumerate(env.observation_names) if ".to_goal_" in name]
# How long it took and what it earned so far says little about what to do next.
SEEN = [i for i, name in enumerate(env.observation_names)
        if not name.startswith(("time_", "points", "harm."))]


def origin(seen):
    """Where the instruments are, as an action."""
    out = np.zeros(len(UNIT))
    for i, k, scale in FROM:
        out[i] = seen[k] * scale
    return out


def features(seen):
    """What is seen, ways to the goal with a resolution of tenths of a millimetre, the step of the task."""
    return np.concatenate([seen[SEEN], np.tanh(seen[GOALS] / 0.7), np.eye(16)[int(min(seen[at("steps_done")], 15))]])


def demonstration(seed):
    """What an expert saw and did, as samples for the network; none when it failed."""
    seen, _ = env.reset(seed=seed)
    expert, full, over, info = placode._placode.Expert(env.handle, "expert", seed), env.actions.rest.copy(), False, {}
    sights, acts = [], []
    while not over:
        finish = expert.act(env.frame_skip, full)
        action = env.actions.part(full)
        action[-1] = finish
        sights.append(seen)
        acts.append(action)
        seen, _, terminated, truncated, info = env.step(action)
        over = terminated or truncated
    acts += [acts[-1]] * AHEAD
    samples = [(features(s), (np.array(acts[i:i + AHEAD]) - origin(s)) * UNIT) for i, s in enumerate(sights)]
    return [(x, y.ravel()) for x, y in samples if info["success"] and np.ptp(y, axis=0).max() > 0.3]


class Network:
    """Two layers of tanh, trained by Adam; the mean of an epoch's weights is what acts."""

    def __init__(self, x, y, rng):
        self.mean, self.spread = (x.mean(0), y.mean(0)), (x.std(0) + 1e-3, y.std(0) + 1e-3)
        sizes = [x.shape[1], WIDTH, WIDTH, y.shape[1]]
        self.weights = [rng.normal(0, a ** -0.5, (a, b)) for a, b in zip(sizes, sizes[1:])]
        self.weights += [np.zeros(b) for b in sizes[1:]]
        self.moments = [np.zeros_like(w) for w in self.weights], [np.zeros_like(w) for w in self.weights]
        self.x, self.y, self.rng, self.steps = self.scaled(x), (y - self.mean[1]) / self.spread[1], rng, 0

    def scaled(self, x):
        return np.clip((x - self.mean[0]) / self.spread[0], -5, 5)

    @staticmethod
    def layers(weights, x):
        out = [x]
        for i in range(3):
            z = out[-1] @ weights[i] + weights[3 + i]
            out.append(np.tanh(z) if i < 2 else z)
        return out

    def act(self, weights, x):
        return self.layers(weights, self.scaled(x))[-1] * self.spread[1] + self.mean[1]

    def epoch(self, rate):
        """One pass over the samples in batches of 128. Returns the mean of the weights on the way."""
        batches = np.array_split(self.rng.permutation(len(self.x)), max(1, len(self.x) // 128))
        mean = [np.zeros_like(w) for w in self.weights]
        for batch in batches:
            out = self.layers(self.weights, self.x[batch])
            slope, slopes = (out[3] - self.y[batch]) / len(batch), [None] * 6
            for i in (2, 1, 0):
                slopes[i], slopes[3 + i] = out[i].T @ slope, slope.sum(0)
                slope = (slope @ self.weights[i].T) * (1 - out[i] ** 2)
            self.steps += 1
            for w, m, v, d, s in zip(self.weights, *self.moments, slopes, mean):
                m += 0.1 * (d - m)
                v += 0.001 * (d * d - v)
                w -= rate * m / (1 - 0.9 ** self.steps) / (np.sqrt(v / (1 - 0.999 ** self.steps)) + 1e-8)
                s += w / len(batches)
        return mean


def attempt(networks, weights, seed):
    """Reward, points and success of an attempt of the networks together."""
    seen, info = env.reset(seed=seed)
    total, steps, over = 0.0, 0, False
    while not over:
        x = features(seen)
        ahead = np.mean([one.act(w, x) for one, w in zip(networks, weights)], axis=0)
        ahead = ahead.reshape(AHEAD, -1) / UNIT + origin(seen)
        for action in np.clip(ahead, env.action_space.low, env.action_space.high):
            action[-1] = 1 if steps >= STEPS else action[-1]
            seen, reward, terminated, truncated, info = env.step(action)
            total, steps, over = total + reward, steps + 1, terminated or truncated
            if over:
                break
    return total, info["points"], info["success"]


samples = [sample for seed in range(1, DEMONSTRATIONS + 1) for sample in demonstration(seed)]
networks = [Network(*map(np.array, zip(*samples)), np.random.default_rng(i)) for i in range(TOGETHER)]
best = (-np.inf, None, 0)
for epoch in range(1, EPOCHS + 1):
    weights = [network.epoch(1e-3 * (1 - epoch / (EPOCHS + 1))) for network in networks]
    if epoch % 3 == 0 or epoch == EPOCHS:
        reward = np.mean([attempt(networks, weights, seed)[0] for seed in CHOOSING])
        print(f"epoch {epoch:3}: reward {reward:.3f}", flush=True)
        best = max(best, (reward, weights, epoch), key=lambda one: one[0])
results = [attempt(networks, best[1], seed) for seed in TESTING]
print(f"{DEMONSTRATIONS} demonstrations, epoch {best[2]}: points {np.median([r[1] for r in results]):.1f} "
      f"({min(r[1] for r in results):.1f} to {max(r[1] for r in results):.1f}), "
      f"{sum(r[2] for r in results)} of {len(results)} passed")
if len(sys.argv) > 5:
    env.handle.write_recording(sys.argv[5])
