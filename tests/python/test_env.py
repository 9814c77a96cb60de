"""AiboEnv: the rules that libraries for learning publish for an environment, and how fast it is."""
import math
import unittest

import openr_host
from openr_host import env


class EnvTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.env = openr_host.AiboEnv(body="ideal", episode_s=0.64)

    @classmethod
    def tearDownClass(cls):
        cls.env.close()

    def episode(self, seed, actions):
        observation, info = self.env.reset(seed=seed)
        seen = [list(observation)]
        for action in actions:
            observation, reward, terminated, truncated, info = self.env.step(action)
            seen.append([*observation, reward, terminated, truncated, info["x_m"]])
        return seen

    def test_a_reset_answers_observation_and_info(self):
        observation, info = self.env.reset(seed=1)
        self.assertEqual(len(observation), self.env.observation_space.shape[0])
        self.assertTrue(self.env.observation_space.contains(observation))
        self.assertIsInstance(info, dict)
        self.assertTrue(all(math.isfinite(each) for each in observation))

    def test_a_step_answers_five_values_of_their_types(self):
        self.env.reset(seed=1)
        observation, reward, terminated, truncated, info = self.env.step(self.env.action_space.sample())
        self.assertTrue(self.env.observation_space.contains(observation))
        self.assertIsInstance(reward, float)
        self.assertIsInstance(terminated, bool)
        self.assertIsInstance(truncated, bool)
        self.assertIsInstance(info, dict)

    def test_a_seed_decides_an_episode(self):
        actions = [[math.sin(i + k) for k in range(12)] for i in range(5)]
        self.assertEqual(self.episode(3, actions), self.episode(3, actions))
        self.assertNotEqual(self.episode(3, actions), self.episode(4, actions))

    def test_without_a_seed_the_next_episode_is_another_one(self):
        first, _ = self.env.reset(seed=3)
        second, _ = self.env.reset()
        self.assertNotEqual(list(first), list(second))

    def test_an_episode_is_truncated_at_its_time(self):
        self.env.reset(seed=1)
        count = 0
        while True:
            _, _, terminated, truncated, _ = self.env.step([0.0] * 12)
            count += 1
            if terminated or truncated:
                break
        self.assertFalse(terminated)
        self.assertEqual(count, 20)  # steps of 32 ms

    def test_actions_outside_of_the_space_are_limited(self):
        self.env.reset(seed=1)
        self.env.step([1e9] * 12)
        targets = self.env.run.targets()
        for name in env.LEG_JOINTS:
            low, high, _ = self.env.run.limits[name]
            self.assertTrue(low <= targets[name] <= high, name)

    def test_an_action_outside_of_the_space_costs_no_more_effort(self):
        costly = openr_host.AiboEnv(body="ideal", effort=1.0)
        self.addCleanup(costly.close)
        for size in (1.0, 3.0, 1e200):
            costly.reset(seed=1)
            self.assertAlmostEqual(costly.step([size] * 12)[1], -1, msg=size)

    def test_an_action_of_a_wrong_length_is_refused(self):
        self.env.reset(seed=1)
        before = self.env.run.time_s
        for count in (0, 11, 13):
            with self.assertRaisesRegex(ValueError, f"has 12 numbers, .*; this one has {count}$"):
                self.env.step([0.0] * count)
        self.assertEqual(self.env.run.time_s, before)

    def test_an_action_that_is_not_finite_is_refused_and_changes_nothing(self):
        self.env.reset(seed=1)
        before = self.env.run.targets()
        for wrong in (math.nan, math.inf, -math.inf):
            with self.assertRaisesRegex(ValueError, f"for LH_j1 is {wrong}; it must be a finite number"):
                self.env.step([1.0] * 3 + [wrong] + [0.0] * 8)
        self.assertEqual(self.env.run.targets(), before)
        _, reward, _, _, _ = self.env.step([0.0] * 12)
        self.assertTrue(math.isfinite(reward))

    def test_a_run_that_ends_terminates_the_episode(self):
        self.env.reset(seed=1)
        self.env.run.press("pause")
        for _ in range(1000):
            _, _, terminated, _, info = self.env.step([0.0] * 12)
            if terminated:
                break
        self.assertEqual(info["ended_by"], "pause")
        self.env.reset(seed=1)
        self.env.step([0.0] * 12)

    def test_the_space_without_a_library(self):
        box = env.Box([-1, 0], [1, 2])
        box.seed(1)
        self.assertTrue(box.contains(box.sample()))
        self.assertFalse(box.contains([2, 0]))
        self.assertFalse(box.contains([0]))

    @unittest.skipIf(env.gymnasium is None or env.numpy is None, "Gymnasium is not installed")
    def test_the_checker_of_gymnasium(self):
        from gymnasium.utils.env_checker import check_env
        check_env(self.env, skip_render_check=True)


class FallTest(unittest.TestCase):
    def test_a_dog_that_falls_ends_its_episode(self):
        falling = openr_host.AiboEnv(body="ode", episode_s=20)
        self.addCleanup(falling.close)
        falling.reset(seed=1)
        falling.run.push(0, 60, 20, for_s=0.4)
        for _ in range(200):
            _, _, terminated, truncated, _ = falling.step([0.0] * 12)
            if terminated or truncated:
                break
        self.assertTrue(terminated)


if __name__ == "__main__":
    unittest.main()
