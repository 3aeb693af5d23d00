#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which room of sim/ includes which, and every include that points upwards:
scripts/include_graph.py [--dot | --table]. Exit status 1 when there is one. The order is that of
CMakeLists.txt."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = re.search(r"set\(sim_rooms ([^)]*)\)", (ROOT / "CMakeLists.txt").read_text())[1].split()


def main() -> int:
    arrows, upwards = collections.Counter(), []
    for path in sorted((ROOT / "sim").rglob("*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        room = path.relative_to(ROOT / "sim").parts[0]
        for target in re.findall(r'^#include "sim/(\w+)/([^"]+)"', path.read_text(), re.M):
            if target[0] == room:
                continue
            arrows[room, target[0]] += 1
            if ROOMS.index(target[0]) > ROOMS.index(room):
                upwards.append(f"{path.relative_to(ROOT)} includes sim/{target[0]}/{target[1]}")
    if "--table" in sys.argv[1:]:
        print("| room | files | " + " | ".join(ROOMS[:-1]) + " |")
        print("|---|---|" + "---|" * (len(ROOMS) - 1))
        for room in ROOMS:
            files = sum(p.suffix in (".h", ".cpp") for p in (ROOT / "sim" / room).iterdir())
            cells = [str(arrows[room, other] or "") for other in ROOMS[:-1]]
            print(f"| {room} | {files} | " + " | ".join(cells) + " |")
    elif "--dot" in sys.argv[1:]:
        print("digraph sim {")
        for (a, b), n in sorted(arrows.items()):
            print(f'  "{a}" -> "{b}" [label={n}];')
        print("}")
    else:
        for (a, b), n in sorted(arrows.items(), key=lambda x: (ROOMS.index(x[0][0]), x[0][1])):
            print(f"{a:8} -> {b:8} {n:4}")
        print(f"{sum(arrows.values())} includes between rooms, {len(upwards)} upwards")
        print("\n".join(upwards))
    return 1 if upwards else 0


if __name__ == "__main__":
    sys.exit(main())
