# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrappers with and without Gymnasium."""

import numpy as np

from .errors import BadArgument
from .spaces import Box, HAS_GYMNASIUM

if HAS_GYMNASIUM:
    from gymnasium import Wrapper
else:
    class Wrapper:
        """Does what the environment in it does."""

        def __init__(self, env):
            self.env = env

        def __getattr__(self, name):
            if name.startswith("_"):
                raise AttributeError(name)
            return getattr(self.env, name)

        @property
        def unwrapped(self):
            return self.env.unwrapped

        def reset(self, *, seed=None, options=None):
            return self.env.reset(seed=seed, options=options)

        def step(self, action):
            return self.env.step(action)

        def render(self):
            return self.env.render()

        def close(self):
            return self.env.close()


class TimeLimit(Wrapper):
    """Truncates after so many steps."""

    def __init__(self, env, max_episode_steps):
        if int(max_episode_steps) < 1:
            raise BadArgument(f"max_episode_steps: expected at least 1, found {max_episode_steps}")
        super().__init__(env)
        self.max_episode_steps = int(max_episode_steps)
        self._steps = 0

    def reset(self, *, seed=None, options=None):
        self._steps = 0
        return self.env.reset(seed=seed, options=options)

    def step(self, action):
        observation, reward, terminated, truncated, info = self.env.step(action)
        self._steps += 1
        return (observation, reward, terminated, truncated or self._steps >= self.max_episode_steps,
                info)


class FrameSkip(Wrapper):
    """Repeats an action; rewards add up."""

    def __init__(self, env, skip):
        if int(skip) < 1:
            raise BadArgument(f"skip: expected at least 1, found {skip}")
        super().__init__(env)
        self.skip = int(skip)

    def step(self, action):
        total = 0.0
        for _ in range(self.skip):
            observation, reward, terminated, truncated, info = self.env.step(action)
            total += reward
            if terminated or truncated:
                break
        return observation, total, terminated, truncated, info


class SelectObservation(Wrapper):
    """Some numbers of the observation, by name: what a small policy needs."""

    def __init__(self, env, names, scale=1.0):
        super().__init__(env)
        known = env.unwrapped.observation_names
        unknown = [name for name in names if name not in known]
        if unknown:
            raise BadArgument(f"no numbers {unknown} in the observation")
        self._where = np.array([known.index(name) for name in names])
        self._scale = np.broadcast_to(np.asarray(scale, np.float64), (len(names),))
        self.observation_names = list(names)
        self.observation_space = Box(-np.inf, np.inf, (len(names),), np.float64)

    def reset(self, *, seed=None, options=None):
        observation, info = self.env.reset(seed=seed, options=options)
        return observation[self._where] * self._scale, info

    def step(self, action):
        observation, *rest = self.env.step(action)
        return (observation[self._where] * self._scale, *rest)
