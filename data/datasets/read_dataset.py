#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a data set of `placodectl dataset`: read_dataset.py TASK.hdf5. Needs python3-h5py."""
import json
import sys

import h5py
import numpy as np


def demonstrations(path, part="train"):
    """Of one part of the split: name, observations (N x names), actions, rewards."""
    with h5py.File(path, "r") as file:
        if part not in file["mask"]:
            return
        for name in file["mask"][part][:]:
            demo = file["data"][name.decode()]
            yield (name.decode(), demo["obs/state"][:], demo["actions"][:], demo["rewards"][:])


def main():
    path = sys.argv[1]
    with h5py.File(path, "r") as file:
        head = dict(file["data"].attrs)
        parts = {part: len(names) for part, names in file["mask"].items()}
    names = json.loads(head["observation_names"])
    steps = 0
    for part in parts:
        for name, seen, actions, rewards in demonstrations(path, part):
            assert seen.shape == (len(actions), len(names)) and np.isfinite(seen).all(), name
            assert np.isfinite(actions).all() and len(rewards) == len(actions), name
            steps += len(actions)
    assert steps == head["total"]
    print(json.dumps({"task": head["task"], "parts": parts, "steps": steps,
                      "observations": len(names), "actions": actions.shape[1],
                      "last_reward": rewards[-1]}))


if __name__ == "__main__":
    main()
