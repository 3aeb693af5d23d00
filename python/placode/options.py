# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What may stand in the options of an environment, said before anything is built."""

import math

import numpy as np

from ._placode import Moment
from .errors import BadArgument

_MOST_SEED = 2**64 - 1
# The least value of each number, and whether it must be more than that.
_WHOLE = {"threads": 1, "lesions": 0, "frame_skip": 1, "width": 1, "height": 1, "num_envs": 1}
_REAL = {"speed_m_s": (0, True), "time_limit_s": (0, False), "start_spread_m": (0, False),
         "judge_every_s": (0, False), "approach_weight": (0, False)}
_YES_OR_NO = ("sparse", "record", "move_scope", "finish_action")


def whole(name, value, least, most=None):
    """`value` as an int. Raises BadArgument for anything else."""
    good = isinstance(value, (int, np.integer)) and not isinstance(value, bool) and value >= least
    if not good or (most is not None and value > most):
        limit = f"from {least}" if most is None else f"from {least} to {most}"
        raise BadArgument(f"{name}: expected a whole number {limit}, found {value!r}")
    return int(value)


def seed_of(value):
    """A seed as an int."""
    return whole("seed", value, 0, _MOST_SEED)


def moment_of(value):
    """A saved moment, and nothing else: None would begin anew."""
    if not isinstance(value, Moment):
        raise BadArgument(f"restore: expected what save() returned, found {value!r}")
    return value


def real(name, value, least, more, most=math.inf):
    """`value` as a finite float from `least` (`more`: above it) to `most`. Raises BadArgument for anything else."""
    good = isinstance(value, (int, float, np.integer, np.floating)) and not isinstance(value, bool)
    good = good and math.isfinite(value) and (value > least if more else value >= least) and value <= most
    if not good:
        limit = f"above {least}" if more else f"from {least}"
        limit += "" if most == math.inf else f" to {most}"
        raise BadArgument(f"{name}: expected a finite number {limit}, found {value!r}")
    return float(value)


def checked(options):
    """The options with numbers as Python's own; unknown names are left to who takes them."""
    out = dict(options)
    for name, value in options.items():
        if name in _WHOLE:
            out[name] = whole(name, value, _WHOLE[name])
        elif name in _REAL:
            out[name] = real(name, value, *_REAL[name])
        elif name in _YES_OR_NO:
            if not isinstance(value, (bool, np.bool_)):
                raise BadArgument(f"{name}: expected True or False, found {value!r}")
            out[name] = bool(value)
        elif name in ("scene", "coarse") and value is not None and not isinstance(value, dict):
            raise BadArgument(f"{name}: expected a dict of changes, found {value!r}")
    return out
