# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrappers with and without Gymnasium."""

import numpy as np

from .errors import BadArgument
from .options import moment_of, whole
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


class _Restoring(Wrapper):
    """A wrapper that goes back to a saved moment as it resets."""

    def restore(self, moment):
        return self.reset(options={"moment": moment_of(moment)})[0]


class TimeLimit(_Restoring):
    """Truncates after so many steps, counted from the beginning of the attempt.

    The attempt itself is not over then and has no points; the option time_limit_s ends it.
    """

    def __init__(self, env, max_episode_steps):
        super().__init__(env)
        self.max_episode_steps = whole("max_episode_steps", max_episode_steps, 1)
        self._steps = 0

    def reset(self, *, seed=None, options=None):
        observation, info = self.env.reset(seed=seed, options=options)
        # A moment lies as many steps behind the beginning as it says on the attempt's clock.
        self._steps = 0
        if options and options.get("moment") is not None:
            inner, frames = self.env, self.unwrapped.frame_skip
            while inner is not self.unwrapped:
                frames *= inner.skip if isinstance(inner, FrameSkip) else 1
                inner = inner.env
            self._steps = round(1000 * self.unwrapped.time_s / frames)
        return observation, info

    def step(self, action):
        observation, reward, terminated, truncated, info = self.env.step(action)
        self._steps += 1
        return (observation, reward, terminated, truncated or self._steps >= self.max_episode_steps,
                info)


class FrameSkip(_Restoring):
    """Repeats an action; rewards add up, and so do their parts in info."""

    _PARTS = ("score_reward", "approach_reward")

    def __init__(self, env, skip):
        super().__init__(env)
        self.skip = whole("skip", skip, 1)

    def step(self, action):
        total, parts = 0.0, dict.fromkeys(self._PARTS, 0.0)
        for _ in range(self.skip):
            observation, reward, terminated, truncated, info = self.env.step(action)
            total += reward
            for part in parts:
                parts[part] += info[part]
            if terminated or truncated:
                break
        info.update(parts)
        return observation, total, terminated, truncated, info


class SelectObservation(_Restoring):
    """Some numbers of the observation, by name: what a small policy needs."""

    def __init__(self, env, names, scale=1.0):
        super().__init__(env)
        known, names = env.unwrapped.observation_names, list(names)
        if not names:
            raise BadArgument("names: expected at least one number of the observation")
        unknown = [name for name in names if name not in known]
        if unknown:
            raise BadArgument(f"no numbers {unknown} in the observation")
        self._where = np.array([known.index(name) for name in names])
        self._scale = np.broadcast_to(np.asarray(scale, np.float64), (len(names),))
        self.observation_names = names
        self.observation_space = Box(-np.inf, np.inf, (len(names),), np.float64)

    def reset(self, *, seed=None, options=None):
        observation, info = self.env.reset(seed=seed, options=options)
        return observation[self._where] * self._scale, info

    def step(self, action):
        observation, *rest = self.env.step(action)
        return (observation[self._where] * self._scale, *rest)
