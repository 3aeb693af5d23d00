#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/dependencies.md: what Placode is built from, with version, licences and what becomes
of it, from packages.txt, what the built programs link, and the copyright files of Debian.

    scripts/dependencies.py [BUILD_FOLDER]       default: build/release
"""
import datetime
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Header files alone: what is used of them becomes part of the programs.
COMPILED_IN = {
    "libeigen3-dev", "libboost-math-dev", "nlohmann-json3-dev", "libvalijson-dev", "libcli11-dev",
    "libcpp-httplib-dev", "libstb-dev", "pybind11-dev",
}
AT_RUN_TIME = {  # opened by Qt or a program, not linked
    "libqt6sql6-sqlite", "libqt6sql6-psql", "libgl1-mesa-dri", "libxcb-cursor0", "libxkbcommon-x11-0",
    "fonts-dejavu-core", "fonts-noto-core", "qt6-translations-l10n", "python3-numpy",
}


def output(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def version_of(package):
    return output("dpkg-query", "-W", "-f", "${Version}", package)


def licences_of(package):
    """Short names of the machine-readable copyright file, most frequent first."""
    path = pathlib.Path("/usr/share/doc") / package / "copyright"
    if not path.exists():
        return ""
    text = path.read_text(errors="replace")
    names = [n.strip() for n in re.findall(r"^License:[ \t]*(\S.*)$", text, re.M)]
    counts = {}
    for name in names:
        counts[name] = counts.get(name, 0) + 1
    short = sorted(counts, key=lambda n: (-counts[n], n))
    if short:
        return ", ".join(short[:4]) + (", ..." if len(short) > 4 else "")
    phrases = {
        "LGPL": "Lesser General Public License", "GPL": "GNU General Public License",
        "GCC runtime exception": "GCC Runtime Library Exception", "Apache": "Apache License",
        "BSD": "Redistribution and use in source and binary forms", "PSF": "PSF LICENSE",
        "MIT": "Permission is hereby granted, free of charge",
    }
    plain = " ".join(text.split())
    found = [name for name, phrase in phrases.items() if phrase in plain]
    return ", ".join(found) if found else "see its copyright file"


def linked_packages(folder):
    """Packages of the shared libraries that the built programs name themselves."""
    wanted = set()
    for program in ("placode", "placode-sim", "placodectl", "placode-web"):
        dynamic = output("readelf", "-d", str(folder / "bin" / program))
        wanted.update(re.findall(r"\(NEEDED\).*\[(.+)\]", dynamic))
    if not wanted:
        sys.exit(f"{folder}: no built programs; run ./run.sh first or name the build folder")
    where = {}  # the first of several is that of this machine's own architecture
    for name, path in re.findall(r"^\s*(\S+) .*=> (\S+)$", output("ldconfig", "-p"), re.M):
        where.setdefault(name, path)
    owners = set()
    for name in sorted(wanted):
        path = str(pathlib.Path(where.get(name, name)).resolve())
        # Some packages still own their files under /lib, which is a link to /usr/lib.
        owner = output("dpkg-query", "-S", path) or output(
            "dpkg-query", "-S", path.removeprefix("/usr"))
        if ":" in owner:
            owners.add(owner.split(":")[0])
    return sorted(owners)


def row(package):
    return f"| {package} | {version_of(package)} | {licences_of(package)} |"


def table(title, packages):
    head = ["", f"## {title}", "", "| package | version | licences |", "|---|---|---|"]
    return head + [row(p) for p in packages]


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build/release"
    lines = (ROOT / "packages.txt").read_text().splitlines()
    listed = [line for line in lines if line and not line.startswith("#")]
    rest = [p for p in listed if p not in COMPILED_IN | AT_RUN_TIME]
    page = [
        "# Dependencies",
        "",
        "Written by `scripts/dependencies.py` from `packages.txt`, the built programs and Debian's",
        f"copyright files, on {datetime.date.today()}. Placode itself is under GPL-3.0-or-later. Nothing is copied",
        "into this tree: Debian delivers every package, with its security updates. Why each of them is",
        "used stands in [ARCHITECTURE.md](../ARCHITECTURE.md). Licences are those of a package's whole source,",
        "most frequent first; what is to build and test becomes no part of the programs.",
    ]
    page += table("Linked by the programs", linked_packages(folder))
    page += table("Compiled into the programs", [p for p in listed if p in COMPILED_IN])
    page += table("Opened while the programs run", [p for p in listed if p in AT_RUN_TIME])
    page += table("To build and test", rest)
    (ROOT / "docs/dependencies.md").write_text("\n".join(page) + "\n")


if __name__ == "__main__":
    main()
