#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
# Learns to touch targets from an expert's attempts, and tries it on lesions that it never saw.
# PYTHONPATH=build/release/python /usr/bin/python3 examples/learn_from_neighbours.py [ATTEMPTS] [FILE.placode]
import sys
import numpy as np
import placode
from placode.policies import Scripted, rollout

env = placode.make("Placode/Reach-v0", scene=placode.COARSEST, units="absolute", lesions=0, record=True)
tip, goal = ([env.observation_names.index(f"tool0.{of}_{axis}_mm") for axis in "xyz"] for of in ("tip", "to_goal"))
sights, plans = [], []

def watched(env):
    expert = Scripted(env, "expert")
    def act(seen):
        shown.append((seen, expert(seen).copy()))
        return shown[-1][1]
    return act

for seed in range(1, 1 + int(sys.argv[1] if len(sys.argv) > 1 else 5)):
    shown = []
    rollout(env, watched, seed)
    for i in range(len(shown) - 15):  # a plan: where the tip is led in 15 steps, seen from where it is
        plan = np.array([led for _, led in shown[i:i + 15]]) - shown[i][0][tip] / 1000
        if np.ptp(plan, axis=0).max() > 3e-4:  # waiting teaches nothing
            sights, plans = sights + [np.tanh(shown[i][0][goal] / 2)], plans + [plan]
sights, plans = np.array(sights), np.array(plans)

def cloned(env):
    plan = []
    def act(seen):
        if not plan:  # as the expert in the five moments that looked most alike
            alike = np.argsort(((sights - np.tanh(seen[goal] / 2)) ** 2).sum(axis=1))[:5]
            plan.extend(plans[alike].mean(axis=0) + seen[tip] / 1000)
        return plan.pop(0)
    return act

for seed in range(201, 206):
    reward, info, steps = rollout(env, cloned, seed)
    print(f"lesion {seed}: reward {reward:.2f}, {info['points']:.0f} points after {steps} steps", flush=True)
if len(sys.argv) > 2:  # to watch: placode-sim --device play:FILE.placode
    env.unwrapped.handle.write_recording(sys.argv[2])
