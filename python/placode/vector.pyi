# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
import enum
from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._placode import Environment, Fields
from .spaces import Box

class AutoresetMode(enum.Enum):
    NEXT_STEP = "NextStep"
    SAME_STEP = "SameStep"
    DISABLED = "Disabled"

class PlacodeVectorEnv:
    metadata: dict[str, Any]
    num_envs: int
    frame_skip: int
    autoreset_mode: AutoresetMode
    handles: tuple[Environment, ...]
    observation_names: list[str]
    action_space: Box
    observation_space: Box
    single_action_space: Box
    single_observation_space: Box
    def __init__(self, task: str, num_envs: int, *, threads: int = 1,
                 autoreset_mode: AutoresetMode = AutoresetMode.NEXT_STEP, frame_skip: int = 20,
                 units: str = "normalised", move_scope: bool = False,
                 finish_action: bool = False, fields: Optional[Fields] = None, **options: Any) -> None: ...
    def reset(self, *, seed: Union[None, int, Sequence[int]] = None,
              options: Optional[dict[str, Any]] = None
              ) -> tuple[NDArray[np.float64], dict[str, Any]]: ...
    @property
    def action_names(self) -> list[str]: ...
    def step(self, actions: ArrayLike
             ) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_],
                        NDArray[np.bool_], dict[str, Any]]: ...
    def close(self, **kwargs: Any) -> None: ...
