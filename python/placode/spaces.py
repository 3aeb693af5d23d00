# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Gymnasium's Box where Gymnasium is installed, else one of our own that does what is needed."""

import numpy as np

try:
    from gymnasium.spaces import Box
    HAS_GYMNASIUM = True
except ImportError:
    HAS_GYMNASIUM = False

    class Box:
        """Arrays of one shape with bounds for every number."""

        def __init__(self, low, high, shape=None, dtype=np.float32, seed=None):
            self.dtype = np.dtype(dtype)
            shape = np.shape(low) if shape is None else tuple(shape)
            self.low = np.broadcast_to(np.asarray(low, self.dtype), shape).copy()
            self.high = np.broadcast_to(np.asarray(high, self.dtype), shape).copy()
            self._np_random = None
            if seed is not None:
                self.seed(seed)

        @property
        def shape(self):
            return self.low.shape

        @property
        def np_random(self):
            if self._np_random is None:
                self.seed()
            return self._np_random

        def seed(self, seed=None):
            self._np_random = np.random.default_rng(seed)
            return seed

        def sample(self):
            """Uniform between the bounds; beyond infinite ones normal."""
            finite = np.isfinite(self.low) & np.isfinite(self.high)
            out = self.np_random.normal(size=self.shape)
            low = np.where(finite, self.low, 0).astype(np.float64)
            high = np.where(finite, self.high, 0).astype(np.float64)
            out = np.where(finite, self.np_random.uniform(low, high), out)
            return np.clip(out, self.low, self.high).astype(self.dtype)

        def contains(self, x):
            return (isinstance(x, np.ndarray) and x.shape == self.shape
                    and np.can_cast(x.dtype, self.dtype)
                    and bool(np.all(x >= self.low) and np.all(x <= self.high)))

        def __contains__(self, x):
            return self.contains(x)

        def __eq__(self, other):
            return (isinstance(other, Box) and self.shape == other.shape
                    and self.dtype == other.dtype and np.array_equal(self.low, other.low)
                    and np.array_equal(self.high, other.high))

        def __repr__(self):
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


def batched(space, count):
    """The same space for `count` environments."""
    shape = (count,) + space.shape
    return Box(np.broadcast_to(space.low, shape), np.broadcast_to(space.high, shape),
               dtype=space.dtype)
