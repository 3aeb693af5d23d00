#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the examples that learn and writes what they reached as a table and a figure.

PYTHONPATH=build/release/python /usr/bin/python3 scripts/learning_curves.py FOLDER
Takes half an hour. Needs python3-matplotlib for the figure. FOLDER gets learning.md and learning.svg.
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
DEMONSTRATIONS = (1, 2, 4, 8, 16)
CLONED = {"trace": "Placode/Trace-v0", "bite": "Placode/Bite-v0"}
RESULT = re.compile(r"epoch (\d+): points ([\d.]+) \(([\d.]+) to ([\d.]+)\), (\d+) of (\d+) passed")


def run(*arguments):
    """Output of an example, and the processor's time that it took [s]."""
    begun = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    out = subprocess.run([sys.executable, *arguments], capture_output=True, text=True, check=True,
                         env=dict(os.environ, OPENBLAS_NUM_THREADS="1")).stdout
    return out, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - begun


def reach():
    out, took = run(os.path.join(EXAMPLES, "learn_to_reach.py"), "12")
    return [float(one) for one in re.findall(r"reward (-?[\d.]+)", out)], took


def cloned(task, demonstrations):
    out, took = run(os.path.join(EXAMPLES, "learn_from_expert.py"), task, str(demonstrations))
    epoch, *points, passed, of = RESULT.search(out).groups()
    return {"epoch": int(epoch), "points": [float(one) for one in points], "passed": int(passed), "of": int(of),
            "seconds": took}


def figure(rewards, results, path):
    left, right = pyplot.subplots(1, 2, figsize=(9, 3.2), constrained_layout=True)[1]
    left.plot(range(len(rewards)), rewards, "o-", color="#0b6e6e")
    left.set(title="reach: reward alone", xlabel="generation of 16 attempts", ylabel="reward of an attempt")
    for (name, one), colour in zip(results.items(), ("#0b6e6e", "#b5541c")):
        x = [DEMONSTRATIONS.index(n) for n in one]
        middle, low, high = zip(*(r["points"] for r in one.values()))
        right.fill_between(x, low, high, color=colour, alpha=0.15, linewidth=0)
        right.plot(x, middle, "o-", color=colour, label=name)
    right.set(title="trace and one bite: from demonstrations", xlabel="demonstrations of the scripted expert",
              ylabel="points of ten attempts", ylim=(-2, 102), xticks=range(len(DEMONSTRATIONS)),
              xticklabels=DEMONSTRATIONS)
    right.legend(frameon=False, loc="lower right")
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(alpha=0.2)
    pyplot.savefig(path, metadata={"Date": None})


def main(folder):
    rewards, took = reach()
    results = {name: {n: cloned(task, n) for n in DEMONSTRATIONS} for name, task in CLONED.items()}
    figure(rewards, results, os.path.join(folder, "learning.svg"))
    with open(os.path.join(folder, "learning.md"), "w", encoding="utf-8") as table:
        table.write(f"# Learned policies\n\nWritten by `scripts/learning_curves.py` on {datetime.date.today()}; "
                    f"{platform.machine()}, {os.cpu_count()} cores, one of them used; seconds of the processor.\n\n"
                    "![What the learners reach](learning.svg)\n\n"
                    f"Reach, by reward alone (`examples/learn_to_reach.py`, seed 7, {took:.0f} s): mean reward of the "
                    f"attempts with seeds 1 and 2 from {rewards[0]:.2f} to {rewards[-1]:.2f} in "
                    f"{len(rewards) - 1} generations.\n\n"
                    "From demonstrations (`examples/learn_from_expert.py`; demonstrations have the seeds from 1 on, the "
                    "reward on seeds 100 to 102 chooses the epoch, seeds 200 to 209 are tested; median, least and most "
                    "of ten attempts):\n\n"
                    "| task | demonstrations | points | least | most | passed | seconds |\n|---|---|---|---|---|---|---|\n")
        for name, one in results.items():
            for n, r in one.items():
                middle, low, high = r["points"]
                table.write(f"| {name} | {n} | {middle:.1f} | {low:.1f} | {high:.1f} | {r['passed']} of {r['of']} | "
                            f"{r['seconds']:.0f} |\n")


main(sys.argv[1])
