#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs the Python package, libplacode.so and the tasks into a wheel.

/usr/bin/python3 scripts/make_wheel.py [BUILD_FOLDER] [OUT_FOLDER]     (build/release, build/release/packages)
The wheel is for the Python that runs this and for Debian 12: it holds no system library. Needs python3-wheel.
"""
import glob
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
NEEDED = "libqt6core6 libsodium23 libzstd1 libsqlite3-0 libhwy1 libglfw3 libepoxy0 libgomp1"
METADATA = f"""Metadata-Version: 2.1
Name: placode
Version: {{version}}
Summary: Tasks of fetoscopic spina bifida repair as Gymnasium environments
License: GPL-3.0-or-later
Requires-Python: >=3.9
Requires-Dist: numpy

The package needs these packages of Debian 12: {NEEDED}.
Pictures need OpenGL 3.3 as well. The page docs/environment.md describes all of it.
"""
WHEEL = """Wheel-Version: 1.0
Generator: scripts/make_wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""


def fail(words):
    sys.exit(f"make_wheel.py: {words}")


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(\w+\s+VERSION\s+([\d.]+)", file.read()).group(1)


def only(pattern):
    found = [path for path in glob.glob(pattern, recursive=True) if not os.path.islink(path)]
    if len(found) != 1:
        fail(f"expected one {os.path.basename(pattern)}, found {len(found)}; build first, with python3-dev, "
             "python3-numpy and pybind11-dev")
    return found[0]


def fill(build, folder):
    """The tree of the wheel: package, library in placode/lib, tasks in placode/share."""
    with tempfile.TemporaryDirectory() as stage:
        done = subprocess.run(["cmake", "--install", build, "--prefix", stage, "--strip"], capture_output=True,
                              text=True)
        if done.returncode != 0:
            fail(f"cmake --install {build} failed: {done.stderr.strip()[-300:]}")
        package = os.path.join(folder, "placode")
        shutil.copytree(os.path.join(stage, "lib", "python3", "dist-packages", "placode"), package)
        only(os.path.join(package, "_placode.*.so"))
        os.mkdir(os.path.join(package, "lib"))
        library = only(os.path.join(stage, "lib", "**", "libplacode.so.*.*.*"))
        soname = re.match(r".*/(libplacode\.so\.\d+)", library).group(1)
        shutil.copy(library, os.path.join(package, "lib", soname))
        shutil.copytree(os.path.join(stage, "share", "placode"), os.path.join(package, "share", "placode"),
                        ignore=shutil.ignore_patterns("manual", "limits.d"))


def main(build, out):
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    tag = f"{tag}-{tag}-linux_{platform.machine()}"
    with tempfile.TemporaryDirectory() as folder:
        fill(build, folder)
        about = os.path.join(folder, f"placode-{version()}.dist-info")
        os.mkdir(about)
        for name, text in ("METADATA", METADATA.format(version=version())), ("WHEEL", WHEEL.format(tag=tag)):
            with open(os.path.join(about, name), "w", encoding="utf-8") as file:
                file.write(text)
        shutil.copy(os.path.join(ROOT, "LICENSE"), about)
        os.makedirs(out, exist_ok=True)
        subprocess.run([sys.executable, "-m", "wheel", "pack", folder, "--dest-dir", out], check=True)


default = os.path.join(ROOT, "build", "release")
main(sys.argv[1] if len(sys.argv) > 1 else default,
     sys.argv[2] if len(sys.argv) > 2 else os.path.join(default, "packages"))
