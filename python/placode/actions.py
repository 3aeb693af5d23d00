# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a policy's action, which has only what a task needs, to the eight numbers of every tool."""

import numpy as np

from . import _placode
from .errors import BadArgument
from .spaces import Box

_NAMES = ("x", "y", "z", "roll", "jaw", "cut", "coag", "engaged")
_REACH_LOW, _REACH_HIGH = (-0.06, -0.06, -0.01), (0.06, 0.06, 0.08)
_TURNS = 4 * np.pi


# Beside where the tip goes: what a tool of each kind can do.
_ABILITIES = {
    "probe": (),
    "needle": ("cut", "coag"),
    "hook": ("roll", "cut", "coag"),
    "grasper": ("roll", "jaw"),
    "scissors": ("roll", "jaw"),
    "needle_driver": ("roll", "jaw"),
    "irrigator": ("cut", "coag"),  # jet and suction
    "scope": (),
}


def _used(kind, shares_port):
    """Numbers that do something for this kind of tool."""
    if kind not in _ABILITIES:
        raise BadArgument(f"a tool of kind {kind!r}; expected one of {', '.join(_ABILITIES)}")
    return ["x", "y", "z", *_ABILITIES[kind], *(["engaged"] if shares_port else [])]


class ActionMap:
    """Which numbers of placode.h's action a policy chooses; the rest stays as it is.

    `names` holds one name per number of the policy's action, e.g. "tool0.x".
    """

    def __init__(self, tools, absolute, move_scope=False, finish_action=False):
        self.absolute = absolute
        self.finish_action = finish_action
        self.where, self.names, low, high = [], [], [], []
        hands = [hand for _, hand in tools]
        for i, (kind, hand) in enumerate(tools):
            if kind == "scope" and not move_scope:
                continue
            shares = kind != "scope" and hands.count(hand) > 1
            for name in _used(kind, shares):
                k = _NAMES.index(name)
                self.where.append(i * _placode.ACTION_SIZE + k)
                self.names.append(f"tool{i}.{name}")
                if not absolute:
                    low.append(-1.0)
                    high.append(1.0)
                elif k < 3:
                    low.append(_REACH_LOW[k])
                    high.append(_REACH_HIGH[k])
                else:
                    low.append(-_TURNS if name == "roll" else 0.0)
                    high.append(_TURNS if name == "roll" else 1.0 if k > 4 else np.pi / 2)
        if finish_action:
            self.names.append("finish")
            low.append(-1.0)
            high.append(1.0)
        dtype = np.float64 if absolute else np.float32
        self.space = Box(np.array(low, dtype), np.array(high, dtype), dtype=dtype)
        # Pedals up, jaws closed, in the port.
        self.rest = np.zeros(len(tools) * _placode.ACTION_SIZE)
        self.rest.reshape(-1, _placode.ACTION_SIZE)[:, 7] = 1.0
        if not absolute:
            self.rest.reshape(-1, _placode.ACTION_SIZE)[:, 4] = -1.0

    def hold(self, tips_m):
        """Absolute units: where tools stay that the policy does not move."""
        if self.absolute:
            self.rest.reshape(-1, _placode.ACTION_SIZE)[:, :3] = tips_m

    def full(self, action, out=None):
        """The action of placode.h, and whether the task is declared done."""
        action = np.asarray(action, dtype=np.float64)
        if action.shape != self.space.shape:
            raise BadArgument(f"an action of shape {action.shape}; expected {self.space.shape}")
        out = self.rest.copy() if out is None else out
        if self.finish_action:
            out[self.where] = action[:-1]
            return out, bool(action[-1] > 0.5)
        out[self.where] = action
        return out, False

    def part(self, full):
        """The policy's action of one of placode.h."""
        numbers = np.asarray(full)[self.where]
        if self.finish_action:
            numbers = np.append(numbers, 0.0)
        return np.clip(numbers.astype(self.space.dtype), self.space.low, self.space.high)
