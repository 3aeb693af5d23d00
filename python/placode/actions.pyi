# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .spaces import Box

class ActionMap:
    absolute: bool
    finish_action: bool
    where: list[int]
    names: list[str]
    space: Box
    rest: NDArray[np.float64]
    def __init__(self, tools: list[tuple[str, str]], absolute: bool, move_scope: bool = False,
                 finish_action: bool = False) -> None: ...
    def hold(self, tips_m: ArrayLike) -> None: ...
    def full(self, action: ArrayLike, out: Optional[NDArray[np.float64]] = None
             ) -> tuple[NDArray[np.float64], bool]: ...
    def part(self, full: ArrayLike) -> NDArray[Any]: ...
