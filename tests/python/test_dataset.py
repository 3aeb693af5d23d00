# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What `placodectl dataset` wrote, given back to an environment, is the same attempt."""

import json
import os
import subprocess
import tempfile
import unittest

import placode
from placode import policies

try:
    import h5py
except ImportError:
    h5py = None


@unittest.skipIf(h5py is None, "needs python3-h5py")
class Demonstrations(unittest.TestCase):
    def test_actions_given_back_earn_the_same_points(self):
        # A bite turns the driver by more than a whole turn.
        env = placode.make("Placode/Bite-v0", scene=placode.COARSE, units="absolute", record=True)
        _, info, steps = policies.rollout(env, policies.Scripted, seed=2)
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "made"))
            env.handle.write_recording(os.path.join(folder, "made", "bite.placode"))
            subprocess.run([os.environ["PLACODECTL"], "dataset", "--recordings", os.path.join(folder, "made"),
                            "--out", os.path.join(folder, "out"), "--licence", "CC BY 4.0"],
                           check=True, capture_output=True)
            with h5py.File(os.path.join(folder, "out", "suture_bite.hdf5")) as file:
                data = file["data"]
                arguments = json.loads(data.attrs["env_args"])["env_kwargs"]
                seed = int(data["demo_0"].attrs["seed"])
                actions = data["demo_0"]["actions"][:]
        self.assertAlmostEqual(len(actions), steps, delta=1)
        again = placode.make(scene=placode.COARSE, **arguments)
        again.reset(seed=seed)
        for i, action in enumerate(actions):
            if i == len(actions) - 1:
                again.finish()
            result = again.step(again.actions.part(action))
            if result[2]:
                break
        self.assertAlmostEqual(result[4]["points"], info["points"], places=3)


if __name__ == "__main__":
    unittest.main()
