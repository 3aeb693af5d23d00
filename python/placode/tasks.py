# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tasks that come as environments."""

import os

from .errors import BadArgument

# Environment id of Gymnasium: task of Placode. "-v0": observation, action or reward change with it.
TASKS = {
    "Placode/Reach-v0": "touch_targets",
    "Placode/Trace-v0": "trace_contour",
    "Placode/GraspLift-v0": "grasp_and_lift",
    "Placode/Traction-v0": "two_handed_traction",
    "Placode/Ring-v0": "diathermy_ring_small",
    "Placode/Resection-v0": "scissors_resection",
    "Placode/Handover-v0": "needle_handover",
    "Placode/Bite-v0": "suture_bite",
    "Placode/RunningSuture-v0": "suture_run",
    "Placode/Dissection-v0": "sb_dissection",
}

# Fields with two substeps that are fast and still tissue: some 13,000 tetrahedra (23,000 as
# published), three times as fast; and some 6,000, six times as fast, for touching and pulling only.
COARSE = {"edge_ring_m": 0.0010, "edge_placode_m": 0.0014, "edge_outer_m": 0.003,
          "solver": {"substeps": 2}}
COARSEST = {"edge_ring_m": 0.0016, "edge_placode_m": 0.0022, "edge_outer_m": 0.0036,
            "solver": {"substeps": 2}}


def task_of(name):
    """Task id of an environment id; any other name stays: a task id or the path of a JSON file."""
    if not isinstance(name, (str, os.PathLike)):
        raise BadArgument(f"task: expected a name or a path, found {name!r}")
    name = os.fspath(name)
    if name.startswith("Placode/") and name not in TASKS:
        raise BadArgument(f"task: no environment {name!r}; expected one of {', '.join(TASKS)}")
    return TASKS.get(name, name)
