# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wrappers with and without Gymnasium."""

import numpy as np

from .errors import BadArgument
from .options import moment_of, real, whole
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


class _Spread:
    """Mean and variance of what came so far, one by one (Welford 1962)."""

    def __init__(self, shape):
        self.count, self.mean, self._squares = 0, np.zeros(shape), np.zeros(shape)

    def add(self, value):
        self.count += 1
        away = value - self.mean
        self.mean = self.mean + away / self.count
        self._squares = self._squares + away * (value - self.mean)

    @property
    def variance(self):
        return self._squares / self.count if self.count > 1 else np.ones(np.shape(self.mean))

    def get(self):
        return self.count, self.mean.copy(), self.variance.copy()

    def set(self, statistics):
        try:
            count, mean, variance = statistics
            mean, variance = np.array(mean, np.float64), np.array(variance, np.float64)
        except (TypeError, ValueError) as error:
            raise BadArgument("statistics: expected count, mean and variance") from error
        if mean.shape != np.shape(self.mean) or variance.shape != mean.shape:
            raise BadArgument(f"statistics: expected mean and variance of shape {np.shape(self.mean)}, found "
                              f"{mean.shape} and {variance.shape}")
        if not np.all(np.isfinite(mean)) or not np.all(np.isfinite(variance)) or np.any(variance < 0):
            raise BadArgument("statistics: expected finite numbers, and variances of at least 0")
        self.count = whole("count", count, 1)
        self.mean, self._squares = mean, variance * self.count


class NormalizeObservation(_Restoring):
    """Observations less their mean, over their standard deviation, both of what was seen so far.

    As Gymnasium's wrapper of this name; cut at +-clip. To judge a policy, keep what it was trained with:
    statistics = (count, mean, variance) can be read and given, update_running_mean = False holds it.
    """

    def __init__(self, env, epsilon=1e-8, clip=10.0):
        super().__init__(env)
        self._epsilon, self._clip = real("epsilon", epsilon, 0, True), real("clip", clip, 0, True)
        shape = env.observation_space.shape
        self.update_running_mean = True
        self.observation_space = Box(-self._clip, self._clip, shape, np.float64)
        self._spread = _Spread(shape)

    @property
    def statistics(self):
        return self._spread.get()

    @statistics.setter
    def statistics(self, value):
        self._spread.set(value)

    def _scaled(self, observation):
        if self.update_running_mean:
            self._spread.add(observation)
        spread = np.sqrt(self._spread.variance + self._epsilon)
        return np.clip((observation - self._spread.mean) / spread, -self._clip, self._clip)

    def reset(self, *, seed=None, options=None):
        observation, info = self.env.reset(seed=seed, options=options)
        return self._scaled(observation), info

    def step(self, action):
        observation, *rest = self.env.step(action)
        return (self._scaled(observation), *rest)


class NormalizeReward(_Restoring):
    """Rewards over the standard deviation of the discounted return so far, as Gymnasium's wrapper.

    info["reward"] keeps what the environment gave.
    """

    def __init__(self, env, gamma=0.99, epsilon=1e-8):
        super().__init__(env)
        self._gamma, self._epsilon = real("gamma", gamma, 0, False, 1), real("epsilon", epsilon, 0, True)
        self.update_running_mean = True
        self._spread, self._return = _Spread(()), 0.0

    def reset(self, *, seed=None, options=None):
        self._return = 0.0
        return self.env.reset(seed=seed, options=options)

    def step(self, action):
        observation, reward, terminated, truncated, info = self.env.step(action)
        self._return = self._gamma * self._return + reward
        if self.update_running_mean:
            self._spread.add(self._return)
        info["reward"] = reward
        return (observation, float(reward / np.sqrt(self._spread.variance + self._epsilon)), terminated, truncated,
                info)
