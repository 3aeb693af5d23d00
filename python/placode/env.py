# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A task of Placode with Gymnasium's interface."""

import json
import weakref

import numpy as np

from . import _placode
from .actions import ActionMap
from .errors import BadArgument
from .options import checked, moment_of, seed_of
from .spaces import Box, HAS_GYMNASIUM
from .tasks import task_of

if HAS_GYMNASIUM:
    from gymnasium import Env as _Env
else:
    class _Env:
        """What Gymnasium's Env gives, for where Gymnasium is not installed."""
        metadata = {"render_modes": []}
        render_mode = None
        spec = None
        _np_random = None

        @property
        def np_random(self):
            if self._np_random is None:
                self._np_random = np.random.default_rng()
            return self._np_random

        @property
        def unwrapped(self):
            return self

        def reset(self, *, seed=None, options=None):
            if seed is not None:
                self._np_random = np.random.default_rng(seed)

        def close(self):
            pass

        def __enter__(self):
            return self

        def __exit__(self, *_):
            self.close()

_shared = None  # weak: fields go when no environment of this program uses them any more
_ENDS = ("going on", "finished", "time limit")


def shared_fields():
    """The fields that all environments of this program share."""
    global _shared
    fields = _shared() if _shared is not None else None
    if fields is None:
        fields = _placode.Fields(8)
        _shared = weakref.ref(fields)
    return fields


def _plain(number):
    """A number of numpy for JSON."""
    if isinstance(number, (np.integer, np.floating)):
        return number.item()
    raise BadArgument(f"scene: {number!r} is no number, text, list or dict")


class FieldsUser:
    """Opens an environment of placode.h with the options that both kinds of environments have."""

    @staticmethod
    def open(task, fields, *, sparse=False, units="normalised", coarse=None, scene=None,
             lesions=4, **options):
        options = checked(dict(options, sparse=sparse, lesions=lesions, coarse=coarse, scene=scene))
        coarse, scene = options.pop("coarse"), options.pop("scene")
        if units not in ("normalised", "absolute"):
            raise BadArgument(f'units: expected "normalised" or "absolute", found {units!r}')
        changes = dict(coarse or {})
        changes.update(scene or {})
        if changes:
            options["scene_changes"] = json.dumps(changes, default=_plain)
        return _placode.Environment(fields, task_of(task), absolute=units == "absolute",
                                    fields=options.pop("lesions"), **options)


class PlacodeEnv(_Env):
    """A task as an environment.

    task        one of placode.TASKS, a task of Placode, or the path of a task's JSON file
    frame_skip  frames of 1 ms for each step
    sparse      reward only at the end: points of the rubric / 100
    units       "normalised" (speeds, -1 to 1) or "absolute" (places in m, angles in rad)
    lesions     seeds share so many lesions; 0: every seed has its own, and a reset takes seconds
    scene       changes of the task's scene, as a dict; placode.COARSE makes it fast
    render_mode "rgb_array" or None; width and height of the picture
    Others as in placode.h: threads, record, speed_m_s, time_limit_s, start_spread_m,
    judge_every_s, approach_weight.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 50}

    def __init__(self, task="Placode/Reach-v0", *, frame_skip=20, render_mode=None, width=320,
                 height=240, move_scope=False, finish_action=False, units="normalised",
                 fields=None, **options):
        if render_mode not in (None, "rgb_array"):
            raise BadArgument(f'render_mode: expected "rgb_array" or None, found {render_mode!r}')
        own = checked({"frame_skip": frame_skip, "width": width, "height": height,
                       "move_scope": move_scope, "finish_action": finish_action})
        self._fields = fields if fields is not None else shared_fields()
        self.handle = FieldsUser.open(task, self._fields, units=units, **options)
        self.frame_skip = own["frame_skip"]
        self.metadata = dict(self.metadata, render_fps=1000 / self.frame_skip)
        self.render_mode = render_mode
        self._size = (own["width"], own["height"])
        self._picture = None
        self.observation_names = self.handle.observation_names
        self._tips = [[self.observation_names.index(f"tool{i}.tip_{axis}_mm") for axis in "xyz"]
                      for i in range(len(self.handle.tools))]
        self._time = self.observation_names.index("time_s")
        self.actions = ActionMap(self.handle.tools, units == "absolute", own["move_scope"],
                                 own["finish_action"])
        self.action_space = self.actions.space
        count = len(self.observation_names)
        self.observation_space = Box(-np.inf, np.inf, (count,), np.float64)
        self._finish = False

    @property
    def action_names(self):
        """What the numbers of an action are, such as "tool0.x"."""
        return self.actions.names

    @property
    def time_s(self):
        """Simulated time since the beginning of the attempt."""
        return float(self._observe()[self._time])

    def _observe(self):
        out = np.empty(self.observation_space.shape)
        self.handle.observe(out)
        return out

    def reset(self, *, seed=None, options=None):
        """A new attempt. options: {"moment": env.save()} goes back to a saved moment instead."""
        if seed is not None:
            seed = seed_of(seed)
        super().reset(seed=seed)
        options = dict(options or {})
        moment = options.pop("moment", None)
        if options:
            raise BadArgument(f"reset: unknown options {sorted(options)}; expected moment")
        self._finish = False
        if moment is not None:
            self.handle.restore(moment)
        else:
            self.handle.reset(int(self.np_random.integers(2**31)) if seed is None else seed)
        observation = self._observe()
        self.actions.hold(observation[self._tips] / 1000)
        return observation, {}

    def finish(self):
        """Declares the task done after the next step."""
        self._finish = True

    def step(self, action):
        full, finish = self.actions.full(action)
        reward, end, success, score, approach, _ = self.handle.step(
            full, self.frame_skip, finish or self._finish)
        observation = self._observe()
        info = {"success": success, "score_reward": score, "approach_reward": approach}
        if end:
            info["end"] = _ENDS[end]
            info.update(json.loads(self.handle.score_json()))
        return observation, reward, end == 1, end == 2, info

    def render(self):
        """The fetoscope's picture (height x width x 3), or None without a render_mode."""
        if self.render_mode is None:
            return None
        if self._picture is None:
            self._picture = _placode.Picture(self.handle, *self._size)
        return self._picture.draw()

    def save(self):
        """This moment, to go back to with reset(options={"moment": ...}) or restore()."""
        return self.handle.save()

    def restore(self, moment):
        """Back to a saved moment: everything goes on bit by bit as it did then."""
        return self.reset(options={"moment": moment_of(moment)})[0]

    def close(self):
        self._picture = None
