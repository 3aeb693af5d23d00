# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tasks of fetoscopic spina bifida repair as environments. See docs/environment.md."""

from . import errors, policies, spaces, wrappers
from ._placode import Fields, Moment
from ._placode import VERSION as __version__
from .env import PlacodeEnv, shared_fields
from .errors import PlacodeError
from .spaces import HAS_GYMNASIUM
from .tasks import COARSE, COARSEST, TASKS, task_of
from .vector import AutoresetMode, PlacodeVectorEnv

__all__ = ["AutoresetMode", "COARSE", "COARSEST", "Fields", "HAS_GYMNASIUM", "Moment", "PlacodeEnv",
           "PlacodeError", "PlacodeVectorEnv", "TASKS", "errors", "make", "make_vec", "policies",
           "shared_fields", "spaces", "task_of", "wrappers"]


def make(task, **options):
    """The environment of a task; options as of PlacodeEnv."""
    return PlacodeEnv(task, **options)


def make_vec(task, num_envs, **options):
    """Many environments of a task; options as of PlacodeVectorEnv."""
    return PlacodeVectorEnv(task, num_envs, **options)


if HAS_GYMNASIUM:
    import gymnasium as _gymnasium

    for _id in TASKS:
        _gymnasium.register(id=_id, entry_point="placode.env:PlacodeEnv",
                            vector_entry_point="placode.vector:PlacodeVectorEnv",
                            kwargs={"task": _id})
    del _id
