# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people do by mistake, and what they rely on without reading: said clearly, or right."""

import unittest

import numpy as np
from test_environment import KEPT, tiny

import placode
from placode import errors, policies, wrappers
from placode.actions import ActionMap


class Options(unittest.TestCase):
    def test_a_wrong_option_is_named_with_its_value(self):
        for name, value in (("lesions", -1), ("lesions", 1.5), ("threads", 0), ("threads", 1.5),
                            ("record", "no"), ("sparse", "no"), ("speed_m_s", -1),
                            ("speed_m_s", np.nan), ("time_limit_s", np.inf), ("time_limit_s", -1),
                            ("frame_skip", 0), ("frame_skip", "20"), ("width", 0),
                            ("finish_action", 1), ("scene", "coarse")):
            with self.subTest(option=name, value=value):
                with self.assertRaisesRegex(errors.BadArgument, f"^{name}: .*{value}"):
                    placode.make("Placode/Reach-v0", **{name: value})

    def test_numbers_of_numpy_are_numbers(self):
        env = tiny(lesions=np.int64(1), threads=np.int32(1), speed_m_s=np.float32(0.02))
        env.reset(seed=np.int64(1))
        changes = {"edge_outer_m": np.float64(0.0032), "solver": {"substeps": np.int64(2)}}
        placode.make("Placode/Reach-v0", scene=changes)

    def test_an_unknown_environment_is_told_what_there_is(self):
        with self.assertRaisesRegex(errors.BadArgument, "Nope.*Placode/Bite-v0"):
            placode.make("Placode/Nope-v0")
        with self.assertRaisesRegex(errors.BadArgument, "task: .*None"):
            placode.make(None)

    def test_every_task_can_be_made(self):
        tasks = KEPT.tasks()
        self.assertIn("irrigate", tasks)
        for task in tasks:
            with self.subTest(task=task):
                self.assertTrue(placode.make(task, fields=KEPT).action_names)
        self.assertEqual(placode.make("irrigate", fields=KEPT).action_names,
                         [f"tool0.{name}" for name in ("x", "y", "z", "cut", "coag")])

    def test_a_tool_of_an_unknown_kind_is_refused(self):
        with self.assertRaisesRegex(errors.BadArgument, "'laser'.*irrigator"):
            ActionMap([("laser", "right")], absolute=False)

    def test_seeds(self):
        for seed in (1.7, -1, True, "1", 2**64):
            with self.subTest(seed=seed), self.assertRaisesRegex(errors.BadArgument, "^seed: "):
                tiny().reset(seed=seed)
        vec = placode.make_vec("Placode/Reach-v0", 2, lesions=1, scene=placode.COARSE)
        for seed in (1.7, [1, 2.5], [1]):
            with self.subTest(seed=seed), self.assertRaisesRegex(errors.BadArgument, "^seed: "):
                vec.reset(seed=seed)


class Moments(unittest.TestCase):
    def test_what_is_no_moment_is_refused(self):
        env = tiny()
        env.reset(seed=1)
        env.step(np.zeros(env.action_space.shape))
        selected = wrappers.SelectObservation(env, ["time_s"])
        for wrong in (None, 3, b""):
            with self.assertRaisesRegex(errors.BadArgument, "save"):
                env.restore(wrong)
            with self.assertRaisesRegex(errors.BadArgument, "save"):
                selected.restore(wrong)
        self.assertGreater(env.time_s, 0)  # nothing began anew

    def test_wrappers_go_back_as_well(self):
        few = wrappers.SelectObservation(tiny(), ["time_s"])
        few.reset(seed=1)
        rest = np.zeros(few.action_space.shape)
        few.step(rest)
        moment = few.unwrapped.save()
        few.step(rest)
        np.testing.assert_allclose(few.restore(moment), [0.02])
        # A limit of steps counts from the beginning of the attempt, whatever lies between.
        limited = wrappers.TimeLimit(wrappers.FrameSkip(tiny(), 2), 4)
        limited.reset(seed=1)
        limited.step(rest)
        moment = limited.unwrapped.save()
        limited.step(rest)
        limited.restore(moment)
        self.assertEqual([limited.step(rest)[3] for _ in range(3)], [False, False, True])


class Parts(unittest.TestCase):
    def test_a_skip_adds_up_the_parts_of_the_reward(self):
        env = wrappers.FrameSkip(tiny(judge_every_s=0.02), 5)
        env.reset(seed=1)
        _, reward, _, _, info = env.step(np.full(env.action_space.shape, -0.5))
        self.assertNotEqual(reward, 0)
        self.assertAlmostEqual(reward, info["score_reward"] + info["approach_reward"])


class Vectors(unittest.TestCase):
    def vector(self, mode, **options):
        return placode.make_vec("Placode/Reach-v0", 3, autoreset_mode=mode, lesions=1,
                                start_spread_m=0.004, time_limit_s=0.06, frame_skip=20,
                                scene=placode.COARSE, **options)

    def test_a_seed_decides_all_that_follows(self):
        seen = []
        for _ in range(2):
            vec = self.vector(placode.AutoresetMode.NEXT_STEP)
            vec.reset(seed=7)
            seen.append(vec.reset()[0])
        np.testing.assert_array_equal(*seen)
        self.assertEqual(vec.action_names[0], "tool0.x")

    def test_some_begin_anew_where_nothing_does_by_itself(self):
        vec = self.vector(placode.AutoresetMode.DISABLED)
        vec.reset(seed=1)
        rest = np.zeros(vec.action_space.shape)
        vec.step(rest)
        mask = np.array([True, False, True])
        seen, _ = vec.reset(options={"reset_mask": mask})
        np.testing.assert_array_equal(seen[:, 0] == 0, mask)
        vec.step(rest)
        infos = vec.step(rest)[4]
        np.testing.assert_array_equal(infos["_points"], [False, True, False])
        vec.reset(options={"reset_mask": ~mask})
        vec.step(rest)
        for wrong in ([True, False], [1, 0, 1], [False] * 3):
            with self.assertRaisesRegex(errors.BadArgument, "reset_mask"):
                vec.reset(options={"reset_mask": wrong})
        with self.assertRaisesRegex(errors.BadArgument, "DISABLED"):
            self.vector(placode.AutoresetMode.NEXT_STEP).reset(options={"reset_mask": mask})

    def test_what_is_for_single_environments_says_so(self):
        for option in ({"width": 64}, {"render_mode": "rgb_array"}):
            with self.assertRaisesRegex(errors.BadArgument, "single"):
                self.vector(placode.AutoresetMode.DISABLED, **option)


class Idle(unittest.TestCase):
    def test_who_does_nothing_earns_nothing(self):
        """On a coarse field, where some sectors of the placode hang on by no path of their own."""
        for task in placode.TASKS:
            env = placode.make(task, scene=placode.COARSE, lesions=2, time_limit_s=0.5)
            for seed in (1, 2):
                total, info, _ = policies.rollout(env, policies.DoNothing, seed)
                self.assertEqual((info["points"], info["verdict"]), (0, "not attempted"), task)
                self.assertLess(abs(total), 1e-3, task)


if __name__ == "__main__":
    unittest.main()
