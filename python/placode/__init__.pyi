# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any

from . import errors as errors, policies as policies, spaces as spaces, wrappers as wrappers
from ._placode import Fields as Fields, Moment as Moment
from .env import PlacodeEnv as PlacodeEnv, shared_fields as shared_fields
from .errors import PlacodeError as PlacodeError
from .vector import AutoresetMode as AutoresetMode, PlacodeVectorEnv as PlacodeVectorEnv

__version__: str
HAS_GYMNASIUM: bool
COARSE: dict[str, Any]
COARSEST: dict[str, Any]
TASKS: dict[str, str]

def task_of(name: str) -> str: ...
def make(task: str, **options: Any) -> PlacodeEnv: ...
def make_vec(task: str, num_envs: int, **options: Any) -> PlacodeVectorEnv: ...
