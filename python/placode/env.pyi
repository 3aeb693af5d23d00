# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._placode import Environment, Fields, Moment
from .actions import ActionMap
from .spaces import Box

def shared_fields() -> Fields: ...

class PlacodeEnv:
    metadata: dict[str, Any]
    render_mode: Optional[str]
    handle: Environment
    frame_skip: int
    actions: ActionMap
    action_space: Box
    observation_space: Box
    observation_names: list[str]
    def __init__(self, task: str = "Placode/Reach-v0", *, frame_skip: int = 20,
                 render_mode: Optional[str] = None, width: int = 320, height: int = 240,
                 move_scope: bool = False, finish_action: bool = False, units: str = "normalised",
                 fields: Optional[Fields] = None, sparse: bool = False, lesions: int = 4,
                 scene: Optional[dict[str, Any]] = None, coarse: Optional[dict[str, Any]] = None,
                 threads: int = 1, record: bool = False, speed_m_s: float = 0.03,
                 time_limit_s: float = 0, start_spread_m: float = 0, judge_every_s: float = 0.5,
                 approach_weight: float = 0.2) -> None: ...
    @property
    def action_names(self) -> list[str]: ...
    @property
    def time_s(self) -> float: ...
    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None
              ) -> tuple[NDArray[np.float64], dict[str, Any]]: ...
    def step(self, action: ArrayLike
             ) -> tuple[NDArray[np.float64], float, bool, bool, dict[str, Any]]: ...
    def finish(self) -> None: ...
    def render(self) -> Optional[NDArray[np.uint8]]: ...
    def save(self) -> Moment: ...
    def restore(self, moment: Moment) -> NDArray[np.float64]: ...
    def close(self) -> None: ...
