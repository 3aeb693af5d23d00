#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a page with a figure of what `placodectl bench environment --out FOLDER` measured.

/usr/bin/python3 scripts/environment_speed.py FOLDER DOCS
DOCS gets environment.md and environment.svg; what policies reach is in it when FOLDER has it (--policies).
Needs python3-matplotlib.
"""
import json
import os
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "placode"
from matplotlib import pyplot

BARS = (("physics_frames_per_s", "physics alone", "#c9d6d3"), ("environment_frames_per_s", "environment", "#0b6e6e"),
        ("python_frames_per_s", "from Python", "#5a7d2a"),
        ("two_processes_frames_per_s", "from Python, two processes together", "#b5541c"),
        ("pictured_frames_per_s", "from Python, a picture every 20 frames", "#7a5aa0"))


def figure(rows, path):
    axes = pyplot.subplots(figsize=(9, 0.75 * len(rows) + 1.2), constrained_layout=True)[1]
    height = 0.82 / len(BARS)
    for k, (key, label, colour) in enumerate(BARS):
        places = [i + (k - (len(BARS) - 1) / 2) * height for i in range(len(rows))]
        axes.barh(places, [row[key] / 1000 for row in rows], height, label=label, color=colour)
    axes.set_yticks(range(len(rows)), [f"{row['task']}\n{row['case']}, {row['tets']:,} tets" for row in rows])
    axes.invert_yaxis()
    axes.set_xscale("log")
    axes.axvline(1, color="#444444", linewidth=0.8)
    axes.axvline(20, color="#444444", linewidth=0.8, linestyle=":")
    ticks = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)
    axes.set_xlabel("times real time (1 = 1,000 frames a second; dotted: 20)")
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="x", alpha=0.2)
    axes.legend(frameon=False, loc="lower center", bbox_to_anchor=(0.4, 1.0), ncols=3)
    pyplot.savefig(path, metadata={"Date": None})


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def main(folder, docs):
    figure(json.loads(text_of(os.path.join(folder, "environment_speed.json")))["rows"],
           os.path.join(docs, "environment.svg"))
    page = ("# Environments: speed, memory, policies\n\nWritten by `placodectl bench environment` and "
            "`scripts/environment_speed.py`.\n\n![Times real time, by task and field](environment.svg)\n\n" +
            text_of(os.path.join(folder, "environment_speed.md")))
    policies = os.path.join(folder, "environment_policies.md")
    if os.path.exists(policies):
        page += "\n## What policies reach\n\n" + text_of(policies)
    with open(os.path.join(docs, "environment.md"), "w", encoding="utf-8") as file:
        file.write(page)


main(sys.argv[1], sys.argv[2])
