# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Sequence

from numpy.typing import ArrayLike

from ._placode import Moment

class Wrapper:
    env: Any
    def __init__(self, env: Any) -> None: ...
    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Any: ...
    def step(self, action: Any) -> Any: ...
    def render(self) -> Any: ...
    def close(self) -> None: ...

class _Restoring(Wrapper):
    def restore(self, moment: Moment) -> Any: ...

class TimeLimit(_Restoring):
    max_episode_steps: int
    def __init__(self, env: Any, max_episode_steps: int) -> None: ...

class FrameSkip(_Restoring):
    skip: int
    def __init__(self, env: Any, skip: int) -> None: ...

class SelectObservation(_Restoring):
    def __init__(self, env: Any, names: Sequence[str], scale: ArrayLike = 1.0) -> None: ...

class NormalizeObservation(_Restoring):
    update_running_mean: bool
    statistics: tuple[int, Any, Any]
    def __init__(self, env: Any, epsilon: float = 1e-8, clip: float = 10.0) -> None: ...

class NormalizeReward(_Restoring):
    update_running_mean: bool
    def __init__(self, env: Any, gamma: float = 0.99, epsilon: float = 1e-8) -> None: ...
