"""States: copies of a run, going back, recordings and their replays."""
import contextlib
import os
import pathlib
import tempfile
import time
import unittest

import openr_host
from standing import close_all, standing


def tearDownModule():
    close_all()


def play(run):
    """Does something of each kind to a run in which the dog stands."""
    run.press("chin", for_s=0.1)
    run.step("message", 5)
    run.set_joints({"neck_pan": 20}, in_s=0.2)
    run.run(0.3)
    run.release_joints()
    run.inject("JointMover.Mover", bytes(4), subject="RCServer.Mover")
    remote = openr_host.Remote(run)
    remote.upload("BOW2.MTN", openr_host.default_motion("BOW.MTN").read_bytes())
    remote.play("BOW2.MTN")
    run.run(0.5)
    run.actuate("LF_j1", "RF_j1")
    run.act([5, 5], frames=10)
    run.act([6, 6], frames=3, ramp=False)
    run.input("break LF_j3 weak 20% for 500ms")
    run.run(1.0031)


@contextlib.contextmanager
def in_folder():
    with tempfile.TemporaryDirectory() as folder:
        yield pathlib.Path(folder)


def has_ended(run, process):
    """Returns whether a process has ended.  `run`, its original, collects it between requests."""
    for _ in range(1000):
        run.status()
        if not os.path.exists(f"/proc/{process}"):
            return True
        time.sleep(0.01)
    return False


class ForkTest(unittest.TestCase):
    def test_copies_go_on_alike_and_apart(self):
        with standing() as run, run.fork() as copy:
            for each in (run, copy):
                each.press("chin", for_s=0.1)
                each.run(1)
            self.assertEqual(run.hashes(), copy.hashes())
            copy.press("chin")
            for each in (run, copy):
                each.run(0.1)
            self.assertNotEqual(run.hashes()[1], copy.hashes()[1])
            self.assertEqual(run.value("sensor.chin"), 0)
            self.assertEqual(copy.value("sensor.chin"), 1)

    def test_copies_have_sticks_of_their_own(self):
        with standing() as run, run.fork() as copy:
            openr_host.Remote(copy).upload("NEW.MTN", openr_host.default_motion("BOW.MTN").read_bytes())
            self.assertIn("NEW.MTN", openr_host.Remote(copy).motions())
            self.assertNotIn("NEW.MTN", openr_host.Remote(run).motions())

    def test_a_copy_outlives_its_original(self):
        run = openr_host.Run(body="ideal")
        run.run(1)
        copy = run.fork()
        second = copy.fork()
        run.close()
        copy.close()
        second.run(1)
        self.assertAlmostEqual(second.time_s, 2)
        second.close()

    def test_a_copy_that_is_dropped_ends(self):
        with standing() as run:
            copies = [run.fork() for _ in range(3)] + [run.save()]
            processes = [each._channel.process for each in copies]
            del copies
            self.assertTrue(all(has_ended(run, each) for each in processes))

    def test_a_picture_does_not_stop_copies(self):
        with in_folder() as folder, openr_host.Run(body="ideal") as run:
            run.run(0.1)
            run.picture(folder / "before.png", size="160x120")
            with run.fork() as copy:
                process = copy._channel.process
                copy.run(1)
                copy.picture(folder / "copy.png", size="160x120")
                run.run(1)
                run.picture(folder / "run.png", size="160x120")
                self.assertEqual(copy.hashes(), run.hashes())
            self.assertTrue(has_ended(run, process))
            self.assertEqual((folder / "copy.png").read_bytes(), (folder / "run.png").read_bytes())

    def test_goes_back_and_the_same_happens_again(self):
        with standing("ode") as run, run.save() as state:
            begin = run.hashes()
            play(run)
            after = run.hashes()
            for _ in range(2):
                run.go_back(state)
                self.assertEqual(run.hashes(), begin)
                play(run)
                self.assertEqual(run.hashes(), after)

    def test_goes_back_with_what_it_observes(self):
        with standing() as run, run.save() as state:
            run.observe("joint.neck_pan")
            run.actuate("neck_pan")
            run.go_back(state)
            self.assertEqual(len(run.act([10], frames=2)), 1)

    def test_goes_back_with_the_joints_that_it_moves(self):
        with standing() as run:
            run.actuate("neck_pan")
            with run.save() as state:
                run.actuate()
                run.go_back(state)
            self.assertEqual(run.actuators, run.joint_names)
            run.act([0.0] * len(run.joint_names), frames=2)

    def test_goes_to_a_state_of_another_model(self):
        with standing() as run, openr_host.Run(body="ideal", robot="ers7") as other:
            run.actuate("neck_pan")
            other.observe("joints")
            with other.save() as state:
                run.go_back(state)
            self.assertEqual((run.model, run.joint_names), (other.model, other.joint_names))
            values = run.act([0.0] * len(other.joint_names), frames=2)
            self.assertEqual(len(values), len(run.observed))

    def test_a_dropped_state_is_gone(self):
        with standing() as run:
            state = run.save()
            state.drop()
            with self.assertRaises(openr_host.ProcessError):
                run.go_back(state)
            run.step()

    def test_many_states_in_turn(self):
        with standing() as run, run.save() as state:
            for _ in range(30):
                run.go_back(state)
                run.step()

    def test_a_chain_of_states_leaves_no_descriptors(self):
        with standing() as run:
            counts = set()
            for _ in range(4):
                with run.save() as state:
                    run.go_back(state)
                counts.add(len(os.listdir(f"/proc/{run._channel.process}/fd")))
            self.assertEqual(len(counts), 1, counts)

    def test_a_chain_of_states_leaves_no_processes(self):
        with openr_host.Run(body="ideal") as run:
            run.run(0.1)
            first = run._channel._popen  # waits for all copies, and collects each that ends
            ended = []
            for _ in range(3):
                with run.save() as state:
                    ended += [run._channel.process, state._channel.process]
                    run.go_back(state)
            for process in ended[1:]:
                self.assertTrue(has_ended(run, process), process)
            self.assertIsNone(first.poll())
            run.run(1)
        self.assertEqual(first.wait(10), 0)

    def test_runs_in_parallel_are_those_in_turn(self):
        with standing() as run:
            def pan_at(degrees):
                with run_copies.pop() as copy:
                    copy.set_joints({"neck_pan": degrees})
                    copy.run(1)
                    return copy.hashes()
            run_copies = [run.fork() for _ in range(8)]
            wanted = openr_host.parallel(pan_at, [1, 2, 3, 4], jobs=1)
            self.assertEqual(openr_host.parallel(pan_at, [1, 2, 3, 4], jobs=4), wanted)
            self.assertEqual(len(set(wanted)), 4)


class RecordTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def replay(self, name, messages=100):
        result = openr_host.replay(self.folder / name)
        self.assertTrue(result.equal, result.difference)
        self.assertGreater(result.messages, messages)
        return result

    def test_a_recording_replays_equal(self):
        for body in ("ideal", "ode"):
            with openr_host.Run(body=body, record=self.folder / "a.rec") as run:
                run.until_standing()
                play(run)
                run.finish()
            self.assertAlmostEqual(self.replay("a.rec").time_s, run.time_s)

    def test_a_recording_is_complete_when_the_run_is_closed(self):
        with openr_host.Run(body="ideal", record=self.folder / "a.rec", seed=5) as run:
            run.run(3)
        self.assertAlmostEqual(self.replay("a.rec").time_s, 3)

    def test_a_recording_ends_with_the_robot(self):
        with openr_host.Run(body="ideal", record=self.folder / "a.rec") as run:
            run.until_standing()
            run.press("pause")
            with self.assertRaises(openr_host.RunEnded):
                run.run(20)
        self.replay("a.rec")

    def test_copies_go_on_with_the_recording_where_asked(self):
        with openr_host.Run(body="ideal", record=self.folder / "a.rec") as run:
            run.until_standing()
            with run.fork(record=self.folder / "b.rec") as one, run.fork() as other:
                one.press("chin", for_s=0.2)
                one.run(1)
                other.run(2)
            run.run(0.5)
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.rec", "b.rec"])
        self.assertLess(self.replay("a.rec").time_s, self.replay("b.rec").time_s)

    def test_the_recording_goes_on_from_a_state(self):
        with openr_host.Run(body="ideal", record=self.folder / "a.rec") as run:
            run.until_standing()
            with run.save() as state:
                run.run(1)
                run.go_back(state, record=self.folder / "b.rec")
            play(run)
        self.replay("a.rec")
        self.replay("b.rec")

    def test_what_cannot_be_recorded_is_refused(self):
        with openr_host.Run(body="ideal") as run:
            with self.assertRaisesRegex(openr_host.Refused, "no recording"):
                run.fork(record=self.folder / "b.rec")
        with openr_host.Run(body="ideal", record=self.folder / "a.rec") as run:
            with self.assertRaisesRegex(openr_host.Refused, "nowhere"):
                run.fork(record="/nowhere/b.rec")
            run.run(1)
        self.replay("a.rec")

    def test_a_recording_that_is_none_is_refused(self):
        (self.folder / "no.rec").write_text("no recording")
        for name in ("no.rec", "missing.rec"):
            with self.assertRaisesRegex(openr_host.Error, name):
                openr_host.replay(self.folder / name)


if __name__ == "__main__":
    unittest.main()
