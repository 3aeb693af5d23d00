#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Learns to go towards targets in three minutes, with the cross-entropy method and numpy alone.

PYTHONPATH=build/release/python /usr/bin/python3 examples/learn_to_reach.py [GENERATIONS] [FILE]
A policy is a matrix from what is seen to the speeds of the tip. FILE.placode: the last attempt,
to watch with `placode-sim --device play:FILE.placode`.
"""
import sys

import numpy as np

import placode

GENERATIONS = int(sys.argv[1]) if len(sys.argv) > 1 else 12
PEOPLE, PARENTS, STEPS, SEED = 16, 4, 400, 7
SEEN = ["tool0.to_goal_x_mm", "tool0.to_goal_y_mm", "tool0.to_goal_z_mm"]
env = placode.wrappers.SelectObservation(
    placode.make("Placode/Reach-v0", scene=placode.COARSE, lesions=2, record=True), SEEN, 0.1)
moves = [env.unwrapped.action_names.index(f"tool0.{axis}") for axis in "xyz"]


def attempt(matrix, seed):
    def policy(_):
        def act(seen):
            action = np.zeros(env.unwrapped.action_space.shape)
            action[moves] = np.tanh(matrix @ np.append(seen, 1))
            return action
        return act
    return placode.policies.rollout(env, policy, seed, STEPS)[0]


rng, mean, spread = np.random.default_rng(SEED), np.zeros((3, 4)), np.ones((3, 4))
for generation in range(GENERATIONS + 1):
    print(f"generation {generation:2}: reward {np.mean([attempt(mean, s) for s in (1, 2)]):.3f}", flush=True)
    if generation == GENERATIONS:
        break
    tried = mean + spread * rng.standard_normal((PEOPLE, 3, 4))
    best = tried[np.argsort([-attempt(one, generation) for one in tried])[:PARENTS]]
    mean, spread = best.mean(axis=0), best.std(axis=0) + 0.1 / (generation + 1)
if len(sys.argv) > 2:
    attempt(mean, 1)
    env.unwrapped.finish()
    env.step(np.zeros(env.unwrapped.action_space.shape))
    env.unwrapped.handle.write_recording(sys.argv[2])
