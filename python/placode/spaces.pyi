# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

HAS_GYMNASIUM: bool

class Box:
    low: NDArray[Any]
    high: NDArray[Any]
    dtype: np.dtype[Any]
    def __init__(self, low: ArrayLike, high: ArrayLike, shape: Optional[tuple[int, ...]] = None,
                 dtype: Any = ..., seed: Optional[int] = None) -> None: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    def seed(self, seed: Optional[int] = None) -> Any: ...
    def sample(self) -> NDArray[Any]: ...
    def contains(self, x: Any) -> bool: ...

def batched(space: Box, count: int) -> Box: ...
