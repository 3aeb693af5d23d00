#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples that learn and writes what they reached as a table and a figure.

PYTHONPATH=build/release/python /usr/bin/python3 scripts/learning_curves.py FOLDER
Takes a quarter of an hour. Needs python3-matplotlib for the figure. FOLDER gets learning.md and learning.svg.
"""
import datetime
import os
import platform
import re
import resource
import subprocess
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "placode"
from matplotlib import pyplot

EXAMPLES = os.path.join(os.path.dirname(__file__), "..", "examples")
# Task, demonstrations, epochs.
CLONED = {"reach": ("Placode/Reach-v0", 8, 12), "trace": ("Placode/Trace-v0", 16, 30),
          "bite": ("Placode/Bite-v0", 24, 12)}
REWARDS = re.compile(r"(?:generation|epoch) +(\d+): reward (-?[\d.]+)")
RESULT = re.compile(r"epoch (\d+): points ([\d.]+) \(([\d.]+) to ([\d.]+)\), (\d+) of (\d+) passed")


def run(*arguments):
    """Output of an example, its rewards, and the processor's time that it took [s]."""
    begun = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    out = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=True,
                         env=dict(os.environ, OPENBLAS_NUM_THREADS="1")).stdout
    print(out, flush=True)
    rewards = [(int(x), float(y)) for x, y in REWARDS.findall(out)]
    return out, rewards, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begun


def figure(reached, cloned, path):
    left, right = pyplot.subplots(1, 2, figsize=(9, 3.4), constrained_layout=True)[1]
    left.plot(*zip(*reached), "o-", color="#0b6e6e")
    left.set(title="reach: from the reward alone", xlabel="generation of 16 attempts", ylabel="reward of an attempt")
    for (name, rewards), colour in zip(cloned.items(), ("#5a7d2a", "#0b6e6e", "#b5541c")):
        right.plot(*zip(*rewards), "o-", color=colour, label=f"{name}, {CLONED[name][1]} demonstrations")
    right.set(title="from an expert", xlabel="epoch")
    right.legend(frameon=False, loc="lower right")
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(alpha=0.2)
    pyplot.savefig(path, metadata={"Date": None})


def main(folder):
    _, reached, took = run(os.path.join(EXAMPLES, "learn_to_reach.py"), "12")
    lines = [f"| reach (`examples/learn_to_reach.py`, seed 7) | reward alone | reward {reached[0][1]:.2f} before, "
             f"{reached[-1][1]:.2f} after {reached[-1][0]} generations | | {took:.0f} |"]
    cloned = {}
    for name, (task, demonstrations, epochs) in CLONED.items():
        out, cloned[name], took = run(os.path.join(EXAMPLES, "learn_from_expert.py"), task, str(demonstrations),
                                      str(epochs))
        epoch, middle, low, high, passed, of = RESULT.search(out).groups()
        lines.append(f"| {name} (`{task}`) | {demonstrations} demonstrations, epoch {epoch} | {middle} points ({low} to "
                     f"{high}) | {passed} of {of} | {took:.0f} |")
    figure(reached, cloned, os.path.join(folder, "learning.svg"))
    with open(os.path.join(folder, "learning.md"), "w", encoding="utf-8") as table:
        table.write(f"# Learned policies\n\nWritten by `scripts/learning_curves.py` on {datetime.date.today()}; "
                    f"{platform.machine()}, {os.cpu_count()} cores, one of them used.\n\n"
                    "![Reward by generation and by epoch](learning.svg)\n\n"
                    "| task | from | reached | passed | seconds of the processor |\n|---|---|---|---|---|\n" +
                    "\n".join(lines) +
                    "\n\nThe coarse field. Reach: mean reward of the attempts with seeds 1 and 2. The others "
                    "(`examples/learn_from_expert.py`): demonstrations of the scripted expert on lesions 1, 2, 3 and so "
                    "on; the curve is the mean reward of attempts on lesions 100 to 102, which choose the epoch; "
                    "median, least and most of ten attempts on lesions 200 to 209, of which nothing was seen before. "
                    "All of it runs again with the same figures; the times do not.\n")


main(sys.argv[1])
