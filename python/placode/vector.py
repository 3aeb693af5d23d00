# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many environments of one task in one call, stepped by threads without the interpreter's lock."""

import enum

import numpy as np

from . import _placode
from .actions import ActionMap
from .env import FieldsUser, shared_fields
from .errors import BadArgument
from .options import checked, seed_of
from .spaces import Box, HAS_GYMNASIUM, batched

if HAS_GYMNASIUM:
    from gymnasium.vector import VectorEnv as _VectorEnv
    try:
        from gymnasium.vector import AutoresetMode
    except ImportError:  # before Gymnasium 1.1
        AutoresetMode = None
else:
    AutoresetMode = None

    class _VectorEnv:
        metadata = {}
        spec = None
        render_mode = None
        closed = False

        def close(self, **_):
            self.closed = True

if AutoresetMode is None:
    class AutoresetMode(enum.Enum):
        """When a finished attempt is followed by the next one; names of Gymnasium."""
        NEXT_STEP = "NextStep"
        SAME_STEP = "SameStep"
        DISABLED = "Disabled"

_MODES = {"NextStep": 0, "SameStep": 1, "Disabled": 2}


class PlacodeVectorEnv(_VectorEnv):
    """`num_envs` environments of one task; options as of PlacodeEnv.

    threads         C++ threads that step them; each environment's physics has one
    autoreset_mode  AutoresetMode.SAME_STEP (infos["final_obs"] holds the last observation),
                    NEXT_STEP or DISABLED, where reset(options={"reset_mask": MASK}) begins
                    anew those that MASK names

    infos["success"] says of every environment whether its attempt passed, infos["points"] has the points
    of those whose attempt ended, infos["score_reward"] and infos["approach_reward"] the parts of the
    rewards. Pictures are for single environments.
    """

    def __init__(self, task, num_envs, *, threads=1, autoreset_mode=AutoresetMode.NEXT_STEP,
                 frame_skip=20, units="normalised", move_scope=False, finish_action=False,
                 fields=None, **options):
        own = checked({"num_envs": num_envs, "threads": threads, "frame_skip": frame_skip,
                       "move_scope": move_scope, "finish_action": finish_action})
        for name in ("render_mode", "width", "height"):
            if name in options:
                raise BadArgument(f"{name}: for single environments only")
        mode = AutoresetMode(autoreset_mode)
        self._fields = fields if fields is not None else shared_fields()
        self.num_envs = own["num_envs"]
        self.frame_skip = own["frame_skip"]
        self.autoreset_mode = mode
        self.metadata = {"autoreset_mode": mode, "render_modes": []}
        self.handles = tuple(FieldsUser.open(task, self._fields, units=units, **options)
                             for _ in range(self.num_envs))
        self._batch = _placode.Batch(self.handles, _MODES[mode.value], own["threads"])
        self.observation_names = self.handles[0].observation_names
        tools = self.handles[0].tools
        self._tips = [[self.observation_names.index(f"tool{i}.tip_{axis}_mm") for axis in "xyz"]
                      for i in range(len(tools))]
        self.actions = ActionMap(tools, units == "absolute", own["move_scope"],
                                 own["finish_action"])
        self.single_action_space = self.actions.space
        self.single_observation_space = Box(-np.inf, np.inf, (len(self.observation_names),),
                                            np.float64)
        self.action_space = batched(self.single_action_space, self.num_envs)
        self.observation_space = batched(self.single_observation_space, self.num_envs)
        self._rng = np.random.default_rng()

    @property
    def action_names(self):
        """What the numbers of one environment's action are, such as "tool0.x"."""
        return self.actions.names

    def _seeds(self, seed):
        """A seed for every environment; without one they follow from the seed given last."""
        if seed is None:
            return [int(s) for s in self._rng.integers(2**31, size=self.num_envs)]
        if np.ndim(seed) == 0:
            seeds = [seed_of(seed) + i for i in range(self.num_envs)]
        else:
            seeds = [seed_of(s) for s in seed]
        if len(seeds) != self.num_envs:
            raise BadArgument(f"seed: expected {self.num_envs} whole numbers, found {len(seeds)}")
        self._rng = np.random.default_rng(seeds)
        return seeds

    def _reset_some(self, mask, seeds):
        """Gymnasium's way to go on after an end where nothing begins by itself."""
        mask = np.asarray(mask)
        if self.autoreset_mode != AutoresetMode.DISABLED:
            raise BadArgument("reset_mask: only where autoreset_mode is DISABLED")
        if mask.dtype != bool or mask.shape != (self.num_envs,) or not mask.any():
            raise BadArgument(f"reset_mask: expected {self.num_envs} booleans, at least one of them "
                              f"true, found {mask!r}")
        observations = np.empty(self.observation_space.shape)
        for i, handle in enumerate(self.handles):
            if mask[i]:
                handle.reset(seeds[i])
            handle.observe(observations[i])
        return observations, {}

    def reset(self, *, seed=None, options=None):
        """seed: one number (environment i gets seed + i), or one for each."""
        options = dict(options or {})
        mask = options.pop("reset_mask", None)
        if options:
            raise BadArgument(f"reset: unknown options {sorted(options)}; expected reset_mask")
        seeds = self._seeds(seed)
        if mask is not None:
            return self._reset_some(mask, seeds)
        observations = np.empty(self.observation_space.shape)
        self._batch.reset(seeds, observations)
        # All start with the same instruments at home.
        self.actions.hold(observations[0][self._tips] / 1000)
        return observations, {}

    def step(self, actions):
        actions = np.asarray(actions, dtype=np.float64)
        if actions.shape != self.action_space.shape:
            raise BadArgument(f"actions of shape {actions.shape}; expected "
                              f"{self.action_space.shape}")
        n = self.num_envs
        full = np.tile(self.actions.rest, (n, 1))
        if self.actions.finish_action:
            self._batch.finish((actions[:, -1] > 0.5).astype(np.uint8))
            actions = actions[:, :-1]
        full[:, self.actions.where] = actions
        observations = np.empty(self.observation_space.shape)
        last = (np.empty(self.observation_space.shape)
                if self.autoreset_mode == AutoresetMode.SAME_STEP else None)
        rewards = np.empty(n)
        terminated, truncated, success = (np.empty(n, np.uint8) for _ in range(3))
        self._batch.step(full, self.frame_skip, observations, last, rewards, terminated,
                         truncated, success)
        terminated, truncated, success = (a.astype(bool) for a in (terminated, truncated, success))
        score, approach, points = (np.empty(n) for _ in range(3))
        self._batch.last(score, approach, points)
        infos = {"success": success, "score_reward": score, "approach_reward": approach}
        infos.update({"_" + name: np.ones(n, bool) for name in infos})
        over = terminated | truncated
        if over.any():
            infos.update(points=np.where(over, points, 0.0), _points=over)
        if last is not None and over.any():
            final = np.full(n, None, dtype=object)
            for i in np.flatnonzero(over):
                final[i] = last[i]
            infos.update(final_obs=final, _final_obs=over)
        return observations, rewards, terminated, truncated, infos
