# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel: complete, and at work away from source and build folder."""

import glob
import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.join(os.path.dirname(__file__), "..", "..", "scripts", "make_wheel.py")
BUILD = os.path.join(os.path.dirname(os.environ["PLACODECTL"]), "..")
TRY = """
import json, placode
env = placode.make("only_in_the_wheel", scene=placode.COARSEST)
env.reset(seed=1)
env.step(env.action_space.sample())
loaded = [line.split()[-1] for line in open("/proc/self/maps") if "libplacode" in line]
print(json.dumps([placode.__file__, loaded[0], env.unwrapped.handle.task_id]))
"""


class Wheel(unittest.TestCase):
    def test_it_works_from_another_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, SCRIPT, BUILD, folder], check=True, capture_output=True)
            wheel, = glob.glob(os.path.join(folder, "placode-*-cp*-linux_*.whl"))
            # Compares every file with its checksum in RECORD.
            subprocess.run([sys.executable, "-m", "wheel", "unpack", wheel, "--dest", folder],
                           check=True, capture_output=True)
            site, = glob.glob(os.path.join(folder, "placode-*", ""))
            tasks = os.path.join(site, "placode", "share", "placode", "tasks")
            self.assertEqual(sorted(os.listdir(tasks)),
                             sorted(os.listdir(os.path.join(os.path.dirname(SCRIPT), "..", "data", "tasks"))))
            # A task that the source tree has not: its tasks were not read instead.
            with open(os.path.join(tasks, "touch_targets.json"), encoding="utf-8") as file:
                text = file.read().replace('"touch_targets"', '"only_in_the_wheel"', 1)
            with open(os.path.join(tasks, "only_in_the_wheel.json"), "w", encoding="utf-8") as file:
                file.write(text)
            environment = {name: value for name, value in os.environ.items() if not name.startswith("PLACODE")}
            done = subprocess.run([sys.executable, "-c", TRY], cwd=folder, capture_output=True, text=True,
                                  env=dict(environment, PYTHONPATH=site))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stdout.count(os.path.realpath(folder)), 2, done.stdout)
            self.assertIn("only_in_the_wheel", done.stdout)

    def test_a_folder_that_is_no_build_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, SCRIPT, folder, folder], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(folder, done.stderr)
            self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    unittest.main()
