# SPDX-FileCopyrightText: 2026 The Placode authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package: Gymnasium's rules, errors, chance, vectors, recordings."""

import ast
import importlib
import os
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

import placode
from placode import errors, policies, wrappers

# A field that a test can afford.
TINY = {"edge_ring_m": 0.0014, "edge_placode_m": 0.0018, "edge_outer_m": 0.0032,
        "solver": {"substeps": 2}}

# Kept from one test to the next: every one of them wants the same fields. The package lets a field go with
# the last environment that uses it.
KEPT = placode.Fields(40)


def tiny(task="Placode/Reach-v0", **options):
    options.setdefault("lesions", 1)
    options.setdefault("fields", KEPT)
    # The suture pad is small: triangles of 1.4 mm do not fit into it.
    scene = placode.COARSE if task in (
        "Placode/Handover-v0", "Placode/Bite-v0", "Placode/RunningSuture-v0") else TINY
    return placode.make(task, scene=scene, **options)


def play(env, seed, steps, rng_seed):
    """What is seen and earned on a random way."""
    rng = np.random.default_rng(rng_seed)
    observation, _ = env.reset(seed=seed)
    seen = [observation]
    for _ in range(steps):
        action = rng.uniform(env.action_space.low, env.action_space.high)
        observation, reward, terminated, truncated, _ = env.step(action)
        seen.append(np.append(observation, reward))
        if terminated or truncated:
            break
    return np.concatenate(seen)


class GymnasiumRules(unittest.TestCase):
    """What gymnasium.utils.env_checker.check_env asks for, in our words; itself where it is."""

    def check(self, env):
        space = env.observation_space
        self.assertEqual(space.dtype, np.float64)
        self.assertTrue(np.all(env.action_space.low < env.action_space.high))
        env.action_space.seed(1)
        self.assertTrue(env.action_space.contains(env.action_space.sample()))
        result = env.reset(seed=123)
        self.assertIsInstance(result, tuple)
        observation, info = result
        self.assertIsInstance(info, dict)
        self.assertTrue(space.contains(observation))
        state = env.unwrapped.np_random.bit_generator.state
        again, _ = env.reset(seed=123)
        np.testing.assert_array_equal(observation, again)
        self.assertEqual(state, env.unwrapped.np_random.bit_generator.state)
        env.reset(seed=456)
        self.assertNotEqual(state, env.unwrapped.np_random.bit_generator.state)
        env.reset()
        env.reset(options={})
        step = env.step(env.action_space.sample())
        self.assertEqual(len(step), 5)
        observation, reward, terminated, truncated, info = step
        self.assertTrue(space.contains(observation))
        self.assertIsInstance(reward, float)
        self.assertTrue(np.isfinite(reward) and np.all(np.isfinite(observation)))
        self.assertIsInstance(terminated, bool)
        self.assertIsInstance(truncated, bool)
        self.assertIsInstance(info, dict)
        self.assertIn("render_fps", env.metadata)
        self.assertIn("rgb_array", env.metadata["render_modes"])
        np.testing.assert_array_equal(play(env, 5, 6, 1), play(env, 5, 6, 1))
        self.assertFalse(np.array_equal(play(env, 5, 6, 1), play(env, 5, 6, 2)))

    def test_every_task(self):
        for task in placode.TASKS:
            with self.subTest(task=task), tiny(task, start_spread_m=0.002) as env:
                self.check(env)

    def test_gymnasium_itself(self):
        if not placode.HAS_GYMNASIUM:
            self.skipTest("gymnasium is not installed")
        import gymnasium
        from gymnasium.utils.env_checker import check_env
        env = gymnasium.make("Placode/Reach-v0", scene=TINY, lesions=1)
        check_env(env.unwrapped, skip_render_check=True)
        env.close()

    def test_registers_with_what_looks_like_gymnasium(self):
        """Debian 12 has no Gymnasium: a stand-in with the names that the package uses."""
        program = """
import enum, sys, types
import numpy as np
import placode.spaces as own
gym, spaces, vector = (types.ModuleType("gymnasium" + n) for n in ("", ".spaces", ".vector"))
registered = {}
class Env:
    metadata = {}
    np_random = None
    @property
    def unwrapped(self): return self
    def reset(self, *, seed=None, options=None):
        self.np_random = np.random.default_rng(seed)
class Wrapper:
    def __init__(self, env): self.env = env
class VectorEnv: pass
class AutoresetMode(enum.Enum):
    NEXT_STEP, SAME_STEP, DISABLED = "NextStep", "SameStep", "Disabled"
class Box(own.Box): pass
gym.Env, gym.Wrapper, spaces.Box = Env, Wrapper, Box
vector.VectorEnv, vector.AutoresetMode = VectorEnv, AutoresetMode
gym.register = lambda id, **what: registered.update({id: what})
gym.spaces, gym.vector = spaces, vector
for name in [n for n in sys.modules if n.startswith("placode")]: del sys.modules[name]
sys.modules.update({"gymnasium": gym, "gymnasium.spaces": spaces, "gymnasium.vector": vector})
import placode
assert placode.HAS_GYMNASIUM and set(registered) == set(placode.TASKS)
for what in registered.values():
    module, name = what["entry_point"].split(":")
    assert hasattr(sys.modules[module], name)
env = placode.make("Placode/Reach-v0", lesions=1, scene=SCENE)
assert isinstance(env, Env) and isinstance(env.action_space, Box)
env.reset(seed=1)
env.step(env.action_space.sample())
assert placode.AutoresetMode is AutoresetMode
assert isinstance(placode.make_vec("Placode/Reach-v0", 2, lesions=1, scene=SCENE), VectorEnv)
print("fine")
"""
        done = subprocess.run([sys.executable, "-c", f"SCENE = {TINY!r}\n{program}"],
                              capture_output=True, text=True, timeout=120)
        self.assertEqual(done.stdout, "fine\n", done.stderr)

    def test_observations_belong_to_the_caller(self):
        env = tiny()
        first, _ = env.reset(seed=1)
        copy = first.copy()
        env.step(env.action_space.high)
        np.testing.assert_array_equal(first, copy)


class Errors(unittest.TestCase):
    def test_wrong_use(self):
        with self.assertRaisesRegex(errors.BadDefinition, "touch_targets"):
            placode.make("touch_target")
        with self.assertRaisesRegex(errors.BadDefinition, "edge_ring_m"):
            placode.make("Placode/Reach-v0", scene={"edge_ring": 1})
        for options in ({"units": "mm"}, {"render_mode": "human"}, {"frame_skip": 0}):
            with self.assertRaises(ValueError):
                placode.make("Placode/Reach-v0", **options)
        with self.assertRaises(TypeError):
            placode.make("Placode/Reach-v0", colour="red")
        env = tiny()
        with self.assertRaisesRegex(errors.NotReset, "reset"):
            env.step(env.action_space.low)
        env.reset(seed=1)
        for action in (np.zeros(99), np.zeros((1, 3)), 0.0, []):
            with self.assertRaisesRegex(errors.BadArgument, "shape"):
                env.step(action)
        for number in (np.nan, np.inf):
            with self.assertRaisesRegex(errors.BadArgument, "not finite"):
                env.step(np.full(env.action_space.shape, number))
        with self.assertRaises((TypeError, ValueError)):
            env.step(["a"] * 3)
        with self.assertRaises(errors.BadArgument):
            env.reset(seed=-1)
        with self.assertRaisesRegex(errors.BadArgument, "moment"):
            env.reset(options={"momentum": 1})
        for out in (np.zeros(3), np.zeros(env.observation_space.shape, np.float32),
                    np.zeros((2,) + env.observation_space.shape)[0:2]):
            with self.assertRaises((errors.BadArgument, TypeError)):
                env.handle.observe(out)
        env.finish()
        *_, terminated, _, info = env.step(np.zeros(env.action_space.shape))
        self.assertTrue(terminated)
        self.assertEqual(info["verdict"], "not attempted")
        with self.assertRaisesRegex(errors.Ended, "reset"):
            env.step(np.zeros(env.action_space.shape))
        with self.assertRaisesRegex(errors.BadArgument, "record"):
            env.handle.write_recording("/tmp/never.placode")
        with self.assertRaisesRegex(errors.BadArgument, "novice"):
            placode.policies.Scripted(tiny(units="absolute"), "champion")
        with self.assertRaisesRegex(errors.BadArgument, "absolute"):
            placode.policies.Scripted(env)

    def test_two_threads_at_once_are_refused(self):
        env = tiny()
        env.reset(seed=1)
        refused, done = [], []

        def step():
            for _ in range(20):
                try:
                    env.step(np.zeros(env.action_space.shape))
                    done.append(1)
                except errors.BadArgument as error:
                    refused.append(str(error))

        threads = [threading.Thread(target=step) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(done) + len(refused), 80)
        self.assertTrue(all("another thread" in words for words in refused))
        self.assertGreater(len(done), 0)

    def test_no_opengl(self):
        """Where nothing can draw, render says so and the environment goes on."""
        program = ("import numpy as np, placode\n"
                   f"env = placode.make('Placode/Reach-v0', lesions=1, scene={TINY!r}, "
                   "render_mode='rgb_array')\n"
                   "env.reset(seed=1)\n"
                   "try:\n    env.render()\n    print('drawn')\n"
                   "except placode.errors.NoPicture as error:\n    print('refused:', error)\n"
                   "env.step(np.zeros(env.action_space.shape))\nprint('goes on')\n")
        # A vendor file that is not there: EGL finds no driver at all.
        env = dict(os.environ, __EGL_VENDOR_LIBRARY_FILENAMES="/nonexistent.json")
        done = subprocess.run([sys.executable, "-c", program], env=env, capture_output=True,
                              text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("refused:", done.stdout)
        self.assertIn("goes on", done.stdout)


class Chance(unittest.TestCase):
    def test_random_actions_over_all_tasks(self):
        """PLACODE_RANDOM_STEPS random actions (10^5 by hand), some of them far out of range."""
        steps = int(os.environ.get("PLACODE_RANDOM_STEPS", "1400"))
        rng = np.random.default_rng(int(os.environ.get("PLACODE_RANDOM_SEED", "1")))
        for task in placode.TASKS:
            for units in ("normalised", "absolute"):
                env = tiny(task, units=units, frame_skip=5, time_limit_s=4, finish_action=True,
                           start_spread_m=0.002)
                env.reset(seed=1)
                left = steps // (2 * len(placode.TASKS))
                low, high = env.action_space.low, env.action_space.high
                while left > 0:
                    action = rng.uniform(low, high)
                    if rng.random() < 0.05:
                        action = action * 10.0 ** rng.uniform(0, 300)
                    action[-1] = -1 if rng.random() < 0.995 else 1
                    for _ in range(int(rng.integers(1, 30))):  # held for a while, as hands do
                        left -= 1
                        observation, reward, terminated, truncated, _ = env.step(action)
                        self.assertTrue(np.isfinite(reward) and np.all(np.isfinite(observation)))
                        if terminated or truncated:
                            env.reset()
                            break


class Moments(unittest.TestCase):
    def test_a_moment_goes_on_as_before(self):
        env = tiny("Placode/Ring-v0")
        rng = np.random.default_rng(1)
        env.reset(seed=1)
        for _ in range(20):
            env.step(rng.uniform(-1, 1, env.action_space.shape))
        moment = env.save()
        self.assertGreater(moment.nbytes, 100_000)
        actions = rng.uniform(-1, 1, (20,) + env.action_space.shape)
        first = [env.step(action)[:2] for action in actions]
        hash_first = env.handle.state_hash()
        env.restore(moment)
        for action, (observation, reward) in zip(actions, first):
            again = env.step(action)
            np.testing.assert_array_equal(observation, again[0])
            self.assertEqual(reward, again[1])
        self.assertEqual(env.handle.state_hash(), hash_first)
        with self.assertRaises(errors.OtherTask):
            tiny("Placode/Trace-v0").restore(moment)


class Operators(unittest.TestCase):
    def test_nothing_that_they_do_is_lost_in_an_action(self):
        """Whatever a scripted operator does with an instrument, a policy can do as well."""
        for task in placode.TASKS:
            env = tiny(task, units="absolute", frame_skip=40)
            env.reset(seed=1)
            operator = placode._placode.Expert(env.handle, "expert", 1)
            wish = np.empty(env.actions.rest.shape)
            moved = [kind != "scope" for kind, _ in env.handle.tools]
            for _ in range(300):
                if operator.act(env.frame_skip, wish):
                    env.finish()
                action = env.actions.part(wish)
                kept = env.actions.full(action)[0].reshape(len(moved), -1)[moved]
                # Hands that are full of one tool are not asked about their place in the port.
                np.testing.assert_allclose(kept[:, :7], wish.reshape(len(moved), -1)[moved][:, :7],
                                           atol=1e-9, err_msg=task)
                if env.step(action)[2]:
                    break

    def test_the_expert_sews(self):
        env = tiny("Placode/Bite-v0", units="absolute")
        _, info, _ = policies.rollout(env, policies.Scripted, seed=1)
        self.assertTrue(info["success"], info["reasons"])
        self.assertEqual(info["metrics"]["needle_entries"], 1)


class Recordings(unittest.TestCase):
    def test_the_expert_passes_and_placodectl_agrees(self):
        env = tiny(units="absolute", record=True, frame_skip=20)
        total, info, _ = policies.rollout(env, policies.Scripted, seed=2)
        self.assertTrue(info["success"])
        self.assertGreater(info["points"], 80)
        self.assertGreater(total, 0.8)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.placode")
            env.handle.write_recording(path)
            with self.assertRaises(errors.FileProblem):
                env.handle.write_recording(path)
            placodectl = os.environ.get("PLACODECTL")
            if placodectl:
                score = subprocess.run([placodectl, "--json", "score", path], capture_output=True,
                                       text=True, check=True).stdout
                self.assertIn(f'"points": {info["points"]!r}'[:16], score)
        self.assertEqual(env.handle.score()[0], info["points"])

    def test_what_there_is_to_see(self):
        env = tiny("Placode/Ring-v0")
        env.reset(seed=1)
        env.step(np.zeros(env.action_space.shape))
        points, cut = env.handle.contour()
        self.assertEqual(points.shape, (len(cut), 3))
        xyz, triangles, damage = env.handle.surface()
        self.assertEqual(damage.shape, (len(xyz), 4))
        self.assertLess(triangles.max(), len(xyz))
        self.assertEqual(len(env.handle.events()[0]), 6)


class Vectors(unittest.TestCase):
    def vector(self, mode, **options):
        return placode.make_vec("Placode/Reach-v0", 3, autoreset_mode=mode, scene=TINY, lesions=1,
                                time_limit_s=0.2, frame_skip=50, **options)

    def test_like_single_environments_with_any_number_of_threads(self):
        for threads in (1, 3):
            vec = self.vector(placode.AutoresetMode.NEXT_STEP, threads=threads)
            rng = np.random.default_rng(1)
            single = [tiny(time_limit_s=0.2, frame_skip=50) for _ in range(3)]
            seen, _ = vec.reset(seed=7)
            for i, env in enumerate(single):
                np.testing.assert_array_equal(seen[i], env.reset(seed=7 + i)[0])
            for _ in range(3):
                actions = rng.uniform(-1, 1, vec.action_space.shape)
                seen, rewards, terminated, truncated, infos = vec.step(actions)
                for i, env in enumerate(single):
                    observation, reward, over, cut_off, _ = env.step(actions[i])
                    np.testing.assert_array_equal(seen[i], observation)
                    self.assertEqual((rewards[i], terminated[i], truncated[i]),
                                     (reward, over, cut_off))
                self.assertEqual(infos["success"].shape, (3,))

    def test_same_step_hands_out_the_last_observation(self):
        vec = self.vector(placode.AutoresetMode.SAME_STEP)
        self.assertEqual(vec.metadata["autoreset_mode"], placode.AutoresetMode.SAME_STEP)
        vec.reset(seed=1)
        actions = np.zeros(vec.action_space.shape)
        for _ in range(3):
            self.assertNotIn("final_obs", vec.step(actions)[4])
        seen, _, _, truncated, infos = vec.step(actions)
        self.assertTrue(truncated.all() and infos["_final_obs"].all())
        self.assertAlmostEqual(infos["final_obs"][0][0], 0.2)
        self.assertEqual(seen[0][0], 0)

    def test_parts_points_and_who_declares_it_done(self):
        for mode in (placode.AutoresetMode.SAME_STEP, placode.AutoresetMode.NEXT_STEP):
            options = {"lesions": 1, "scene": TINY, "units": "absolute", "finish_action": True,
                       "frame_skip": 50}
            vec = placode.make_vec("Placode/Reach-v0", 2, autoreset_mode=mode, **options)
            self.assertEqual(vec.action_names[-1], "finish")
            single = [placode.make("Placode/Reach-v0", **options).unwrapped for _ in range(2)]
            vec.reset(seed=1)
            experts = []
            for i, env in enumerate(single):
                env.reset(seed=1 + i)
                experts.append(placode.policies.Scripted(env, "expert", 1 + i))
            for step in range(160):
                actions = np.array([expert(None) for expert in experts])
                actions[1, -1] = 1.0 if step == 150 else 0.0
                _, rewards, terminated, _, infos = vec.step(actions)
                for i, env in enumerate(single[:1 if step > 150 else 2]):
                    _, reward, over, _, info = env.step(actions[i])
                    self.assertEqual((reward, over, info["score_reward"], info["approach_reward"]),
                                     (rewards[i], terminated[i], infos["score_reward"][i],
                                      infos["approach_reward"][i]))
                    self.assertEqual(over, i == 1 and step == 150)
                if step == 150:
                    np.testing.assert_array_equal(infos["_points"], [False, True])
                    self.assertEqual(infos["points"][1], info["points"])
                    self.assertGreater(info["points"], 0)
                elif step < 150:
                    self.assertNotIn("points", infos)
                else:
                    break
            with self.assertRaises(errors.BadArgument):
                vec._batch.finish(np.zeros(3, np.uint8))

    def test_next_step_and_disabled(self):
        vec = self.vector(placode.AutoresetMode.NEXT_STEP)
        vec.reset(seed=[1, 2, 3])
        actions = np.zeros(vec.action_space.shape)
        for _ in range(4):
            seen, _, _, truncated, _ = vec.step(actions)
        self.assertTrue(truncated.all())
        self.assertAlmostEqual(seen[0][0], 0.2)
        seen, rewards, _, truncated, _ = vec.step(actions)
        self.assertFalse(truncated.any() or rewards.any() or seen[0][0])
        vec = self.vector(placode.AutoresetMode.DISABLED)
        vec.reset(seed=1)
        for _ in range(4):
            vec.step(actions)
        with self.assertRaises(errors.Ended):
            vec.step(actions)
        vec.reset()
        with self.assertRaises(errors.BadArgument):
            vec.step(actions[:2])
        with self.assertRaises(errors.BadArgument):
            vec.reset(seed=[1, 2])

    def test_fields_are_shared(self):
        fields = placode.Fields()
        envs = [tiny(fields=fields) for _ in range(3)]
        for seed, env in enumerate(envs):
            env.reset(seed=seed)
        self.assertEqual(fields.built, 1)


class Wrappers(unittest.TestCase):
    def test_time_limit_skip_and_selection(self):
        env = wrappers.TimeLimit(tiny(), 3)
        env.reset(seed=1)
        ends = [env.step(np.zeros(env.action_space.shape))[3] for _ in range(3)]
        self.assertEqual(ends, [False, False, True])
        skipped = wrappers.FrameSkip(tiny(), 4)
        skipped.reset(seed=1)
        seen = skipped.step(np.zeros(skipped.action_space.shape))[0]
        self.assertAlmostEqual(seen[0], 0.08)
        few = wrappers.SelectObservation(tiny(), ["tool0.to_goal_x_mm", "time_s"], [0.1, 1])
        self.assertEqual(few.reset(seed=1)[0].shape, few.observation_space.shape)
        self.assertAlmostEqual(few.step(np.zeros(few.action_space.shape))[0][1], 0.02)
        with self.assertRaises(errors.BadArgument):
            wrappers.SelectObservation(tiny(), ["tool0.smell"])

    def test_observations_are_normalised_by_what_was_seen(self):
        few = wrappers.SelectObservation(tiny(), ["tool0.tip_x_mm", "tool0.to_goal_z_mm", "time_s"])
        env = wrappers.NormalizeObservation(few)
        policy = policies.Random(tiny(), seed=3)
        raw = [few.reset(seed=1)[0]]
        raw += [few.step(policy(None))[0] for _ in range(40)]
        policy = policies.Random(tiny(), seed=3)
        seen = [env.reset(seed=1)[0]]
        seen += [env.step(policy(None))[0] for _ in range(40)]
        count, mean, variance = env.statistics
        self.assertEqual(count, 41)
        np.testing.assert_allclose(mean, np.mean(raw, axis=0), rtol=1e-12)
        np.testing.assert_allclose(variance, np.var(raw, axis=0), rtol=1e-12)
        np.testing.assert_allclose(
            seen[-1], (raw[-1] - mean) / np.sqrt(variance + 1e-8), rtol=1e-12)
        self.assertTrue(all(env.observation_space.contains(one) for one in seen))
        # To judge: as trained, and held.
        judge = wrappers.NormalizeObservation(few, clip=0.5)
        judge.statistics = env.statistics
        judge.update_running_mean = False
        np.testing.assert_allclose(
            judge.reset(seed=1)[0], np.clip((raw[0] - mean) / np.sqrt(variance + 1e-8), -0.5, 0.5))
        self.assertEqual(judge.statistics[0], 41)
        for wrong in (None, (1, [0, 0], [1, 1]), (1, [0, 0, 0], [1, -1, 1]), (0, mean, variance),
                      (1, [0, 0, np.nan], [1, 1, 1])):
            with self.assertRaises(errors.BadArgument):
                judge.statistics = wrong
        for clip in (0, -1, np.inf, "10", None):
            with self.assertRaises(errors.BadArgument):
                wrappers.NormalizeObservation(few, clip=clip)

    def test_rewards_are_normalised_by_the_return(self):
        env = wrappers.NormalizeReward(tiny(), gamma=0.9)
        policy = policies.Random(tiny(), seed=5)
        env.reset(seed=1)
        total, returns = 0.0, []
        for _ in range(30):
            _, reward, _, _, info = env.step(policy(None))
            total = 0.9 * total + info["reward"]
            returns.append(total)
        self.assertAlmostEqual(reward, info["reward"] / np.sqrt(np.var(returns) + 1e-8), places=10)
        with self.assertRaises(errors.BadArgument):
            wrappers.NormalizeReward(tiny(), gamma=1.5)

    def test_sparse_reward_comes_at_the_end(self):
        env = tiny(sparse=True, units="absolute")
        total, info, steps = policies.rollout(env, policies.Scripted, seed=1)
        self.assertAlmostEqual(total, info["points"] / 100)
        dense = tiny(units="absolute", approach_weight=0.0)
        total, again, _ = policies.rollout(dense, policies.Scripted, seed=1)
        self.assertAlmostEqual(total, again["points"] / 100)
        self.assertEqual(again["points"], info["points"])
        self.assertGreater(steps, 10)


class Pictures(unittest.TestCase):
    def test_a_picture(self):
        env = tiny(render_mode="rgb_array", width=160, height=120)
        env.reset(seed=1)
        env.step(np.zeros(env.action_space.shape))
        try:
            picture = env.render()
        except errors.NoPicture as error:
            self.skipTest(str(error))
        self.assertEqual((picture.shape, picture.dtype), ((120, 160, 3), np.uint8))
        self.assertGreater(picture.std(), 10)
        drawn = []  # by another thread as well
        thread = threading.Thread(target=lambda: drawn.append(env.render()))
        thread.start()
        thread.join()
        self.assertEqual(drawn[0].shape, picture.shape)
        self.assertIsNone(tiny().render())


class Examples(unittest.TestCase):
    """The scripts of docs/environment.md, in short form."""

    ROOT = os.path.join(os.path.dirname(__file__), "..", "..")

    def learn(self, script, arguments, expected, task):
        """The output has what is expected, and the attempt can be read and replays identically."""
        script = os.path.join(self.ROOT, "examples", script)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "last.placode")
            done = subprocess.run([sys.executable, script, *arguments, path], capture_output=True,
                                  text=True, check=True, timeout=300)
            self.assertRegex(done.stdout, expected)
            metrics = subprocess.run([os.environ["PLACODECTL"], "--json", "metrics", path],
                                     capture_output=True, text=True, check=True).stdout
            self.assertIn(task, metrics)
            viewer = os.path.join(os.path.dirname(os.environ["PLACODECTL"]), "placode-sim")
            shown = subprocess.run([viewer, "--device", "play:" + path, "--headless", "--threads", "1"],
                                   capture_output=True, text=True, check=True).stdout
            self.assertIn("replay: identical", shown)

    def test_the_script_in_the_page(self):
        with open(os.path.join(self.ROOT, "examples", "learn_from_neighbours.py"), encoding="utf-8") as file:
            script = file.read()
        with open(os.path.join(self.ROOT, "docs", "environment.md"), encoding="utf-8") as file:
            self.assertIn("```python\n" + script[script.index("import sys"):] + "```", file.read())
        self.learn("learn_from_neighbours.py", ["1"], "(lesion [0-9]+: reward [0-9.]+, [0-9]+ points.*\n){5}",
                   "touch_targets")

    def test_learns_by_reward(self):
        self.learn("learn_to_reach.py", ["1"], "generation +1: reward -?[0-9]", "touch_targets")

    def test_learns_from_an_expert(self):
        self.learn("learn_from_expert.py", ["Placode/Trace-v0", "1", "2", "1"],
                   "1 demonstrations, epoch 2: points [0-9.]+ .*, [01] of 1 passed", "trace_contour")


class Stubs(unittest.TestCase):
    def test_what_they_promise_is_there(self):
        folder = os.path.dirname(placode.__file__)
        checked = 0
        for name in sorted(os.listdir(folder)):
            if not name.endswith(".pyi"):
                continue
            module = importlib.import_module(
                "placode" if name == "__init__.pyi" else "placode." + name[:-4])
            with open(os.path.join(folder, name), encoding="utf-8") as text:
                tree = ast.parse(text.read())
            for node in tree.body:
                if isinstance(node, ast.AnnAssign):
                    self.assertTrue(hasattr(module, node.target.id), f"{name}: {node.target.id}")
                if not isinstance(node, (ast.ClassDef, ast.FunctionDef)):
                    continue
                self.assertTrue(hasattr(module, node.name), f"{name}: {node.name}")
                for part in node.body:
                    if isinstance(part, ast.FunctionDef):
                        checked += 1
                        self.assertTrue(hasattr(getattr(module, node.name), part.name),
                                        f"{name}: {node.name}.{part.name}")
        self.assertGreater(checked, 40)


if __name__ == "__main__":
    unittest.main()
