# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Policies to compare with: nothing, chance, and the scripted operators."""

import numpy as np

from . import _placode
from .errors import BadArgument


class DoNothing:
    """Leaves the instruments where they are."""

    def __init__(self, env):
        self._env = env.unwrapped

    def __call__(self, observation):
        return self._env.actions.part(self._env.actions.rest)


class Random:
    """Actions by chance, by seed."""

    def __init__(self, env, seed=0):
        self._space = env.unwrapped.action_space
        self._rng = np.random.default_rng(seed)

    def __call__(self, observation):
        return self._rng.uniform(self._space.low, self._space.high).astype(self._space.dtype)


class Scripted:
    """A scripted operator: "expert", "intermediate" or "novice". Needs units="absolute".

    It sees what a person sees, not the observation. Make a new one for every attempt.
    """

    def __init__(self, env, level="expert", seed=1):
        self._env = env.unwrapped
        if not self._env.actions.absolute:
            raise BadArgument('a scripted operator needs an environment with units="absolute"')
        self._expert = _placode.Expert(self._env.handle, level, int(seed))
        self._full = np.empty(self._env.actions.rest.shape)

    def __call__(self, observation):
        if self._expert.act(self._env.frame_skip, self._full):
            self._env.finish()
        return self._env.actions.part(self._full)


def rollout(env, policy, seed=None, most_steps=None):
    """One attempt. Returns the sum of rewards, the last info and the number of steps."""
    observation, info = env.reset(seed=seed)
    policy = policy(env)
    total, steps, over = 0.0, 0, False
    while not over and (most_steps is None or steps < most_steps):
        observation, reward, terminated, truncated, info = env.step(policy(observation))
        total += reward
        steps += 1
        over = terminated or truncated
    return total, info, steps
