"""Runs: going on, looking, inputs, messages."""
import math
import os
import pathlib
import struct
import tempfile
import unittest
import unittest.mock

import openr_host
from standing import close_all, standing


def tearDownModule():
    close_all()


class RunTest(unittest.TestCase):
    def setUp(self):
        self.run_ = standing()
        self.addCleanup(self.run_.close)

    def test_tells_about_the_robot(self):
        self.assertEqual(self.run_.model, "ERS-210")
        self.assertEqual(self.run_.joint_names[:3], ("neck_tilt", "neck_pan", "neck_roll"))
        self.assertIn("chin", self.run_.sensor_names)
        low, high, speed = self.run_.limits["neck_pan"]
        self.assertLess(low, 0)
        self.assertGreater(high, 0)
        self.assertGreater(speed, 0)

    def test_steps_over_frames_messages_and_vectors(self):
        begin_s = self.run_.time_s
        self.run_.step()
        self.assertAlmostEqual(self.run_.time_s, begin_s + 0.008)
        messages = self.run_.status()["messages"]
        self.run_.step("message", 3)
        self.assertEqual(self.run_.status()["messages"], messages + 3)
        self.run_.step("vector")  # several objects receive each vector
        begin_s = self.run_.time_s
        self.run_.step("vector", 20)
        self.assertGreater(self.run_.time_s, begin_s + 0.032)

    def test_a_wrong_step_is_refused_and_changes_nothing(self):
        before = self.run_.hashes()
        for over, count in (("frames", 1), ("frame", 0), ("frame", -1)):
            with self.assertRaises(openr_host.Refused):
                self.run_.step(over, count)
        self.assertEqual(self.run_.hashes(), before)

    def test_runs_to_a_time_and_not_into_the_past(self):
        self.run_.run_to(self.run_.time_s + 1)
        with self.assertRaisesRegex(openr_host.Refused, "in the past"):
            self.run_.run_to(0.5)

    def test_a_value_has_the_type_that_is_asked_for(self):
        self.assertIsInstance(self.run_.value("sensor.chin", float), float)
        self.assertEqual(self.run_.value("objects.JointMover.state", str), "accepting-commands")
        with self.assertRaisesRegex(openr_host.Error, "'accepting-commands', which is no float"):
            self.run_.value("objects.JointMover.state", float)
        with self.assertRaisesRegex(openr_host.Error, "which is no str"):
            self.run_.value("height_mm", str)
        with self.assertRaisesRegex(openr_host.Error, "neither float nor str"):
            self.run_.value("sensor.chin", int)

    def test_until_takes_texts_and_functions(self):
        self.run_.press("chin")
        self.run_.until("robots[0].sensor.chin == 1", within_s=1)
        self.run_.release("chin")
        self.run_.until(lambda run: run.value("sensor.chin") == 0, within_s=1)
        with self.assertRaisesRegex(openr_host.NotMet, "x_m > 5"):
            self.run_.until("robots[0].x_m > 5", within_s=0.1)
        with self.assertRaisesRegex(openr_host.NotMet, "within 0.05 s"):
            self.run_.until(lambda run: False, within_s=0.05)
        for wrong in ("x_m >", "robots[0].z_m > 3", "joints > 3", ""):
            with self.assertRaises(openr_host.Refused, msg=wrong):
                self.run_.until(wrong, within_s=1)

    def test_reads_values_by_name(self):
        values = self.run_.read("objects.JointMover.state", "height_mm", "joint.LF_j1", "sensor.chin")
        self.assertEqual(values["objects.JointMover.state"], "accepting-commands")
        self.assertGreater(values["robots[0].height_mm"], 100)
        self.assertEqual(len(self.run_.read("joints")), len(self.run_.joint_names))
        with self.assertRaisesRegex(openr_host.Refused, "did you mean 'LF_j1'"):
            self.run_.read("joint.LF_j11")
        with self.assertRaisesRegex(openr_host.Refused, "no robot 7"):
            self.run_.read("robots[7].joints")

    def test_observes_numbers_in_the_order_of_their_names(self):
        self.assertEqual(self.run_.observe(), ())
        names = self.run_.observe("joint.neck_pan", "paws", "height_mm")
        self.assertEqual(self.run_.observe(), names)
        self.assertEqual(names[0], "robots[0].joint.neck_pan")
        values = self.run_.observation()
        self.assertEqual(list(values[1:5]), [1, 1, 1, 1])
        self.assertAlmostEqual(values[5], self.run_.value("height_mm"))
        with self.assertRaisesRegex(openr_host.Refused, "numbers only"):
            self.run_.observe("objects.JointMover.state")
        self.assertEqual(list(self.run_.observation()), list(values))

    def test_acts_with_set_points(self):
        self.run_.actuate("neck_pan", "neck_tilt")
        self.run_.observe("joint.neck_pan", "target.neck_pan")
        values = self.run_.act([20, -10], frames=50)
        self.assertAlmostEqual(values[0], 20, places=2)
        self.assertAlmostEqual(values[1], 20, places=3)
        with self.assertRaisesRegex(openr_host.Refused, "2 joints need 16"):
            self.run_.act([1.0])
        with self.assertRaisesRegex(openr_host.Refused, "beyond the stops"):
            self.run_.act([1000, 0])
        with self.assertRaises(openr_host.Refused):
            self.run_.act([float("nan"), 0])

    def test_set_joints_last_until_they_are_released(self):
        self.run_.set_joints({"neck_pan": 30}, in_s=0.4)
        self.run_.run(0.2)
        self.assertAlmostEqual(self.run_.joints()["neck_pan"], 15, delta=1)
        self.run_.run(0.5)
        self.assertAlmostEqual(self.run_.joints()["neck_pan"], 30, places=2)
        self.run_.release_joints()
        remote = openr_host.Remote(self.run_)
        remote.move("neck_pan", -10)
        self.run_.run(2)
        self.assertAlmostEqual(self.run_.joints()["neck_pan"], -10, delta=0.1)

    def test_inputs_that_are_wrong_are_refused(self):
        for line in ("pres chin", "press nose", "press chin for ever", ""):
            with self.assertRaises(openr_host.Refused, msg=line):
                self.run_.input(line)
        with self.assertRaisesRegex(openr_host.Refused, "no robot 3"):
            self.run_.press("chin", robot=3)

    def test_a_session_that_asks_amiss_goes_on(self):
        ask = self.run_._channel.ask
        for text in (b"", b"[]", b"{", b'{"do": 5}', b'{"do": "runn"}', b'{"do": "run", "for_s": "1"}',
                     b'{"do": "run", "for": 1}', b'{"do": "until"}', b'{"do": "run", "for_s": -1}',
                     b'{"do": "run", "for_s": 1e300}', b'{"do": "start"}', b'{"do": "boot"}',
                     b'{"do": "fork"}', b'{"do": "connect", "port": 70000}', b'\xff\xfe'):
            with self.assertRaises(openr_host.Refused, msg=text):
                ask(text)
        deep = b'{"do": "run", "for_s": ' + b"[" * 100 + b"]" * 100 + b"}"
        with self.assertRaisesRegex(openr_host.Refused, "^the JSON is nested more than 100 levels deep$"):
            ask(deep)
        self.run_.step()

    def test_expects_and_injects_messages(self):
        # SetValueMessage, MoverCommand and the like are named by their services.
        self.run_.inject("JointMover.Mover", bytes(4), subject="RCServer.Mover")
        message = self.run_.expect("RCServer.Mover", "JointMover.Mover", kind="notify", within_s=0.1)
        self.assertEqual(message.kind, "notify")
        self.assertTrue(message.sender.startswith("RCServer.Mover."))
        self.assertEqual(message.data, bytes(4))
        with self.assertRaisesRegex(openr_host.NotMet, "notify RCServer.Mover -> JointMover"):
            self.run_.expect("RCServer.Mover", "JointMover", kind="notify", within_s=0.1)
        for wrong in ({"kind": "noise"}, {"sender": "RCServre"}, {"receiver": "JointMover.Moverr"}):
            with self.assertRaises(openr_host.Refused, msg=wrong):
                self.run_.expect(**wrong)
        with self.assertRaises(openr_host.Refused):
            self.run_.inject("JointMover.Nothing", b"1")

    def test_messages_say_what_they_mean(self):
        # MoverCommand of objects/common/Messages.h: kind 7 is motor on, joint -1 is all joints.
        on = (7).to_bytes(4, "little") + (-1).to_bytes(4, "little", signed=True) + bytes(40)
        self.run_.inject("JointMover.Mover", on, subject="RCServer.Mover")
        message = self.run_.expect("RCServer.Mover", "JointMover.Mover", kind="notify", within_s=0.1)
        self.assertEqual(message.text, "motor power on")
        self.assertRegex(repr(message), r"JointMover\.Mover\.MoverCommand\.O, 48 bytes: motor power on\)$")
        sensors = self.run_.expect("OVirtualRobotComm.Sensor", "RCServer", kind="notify", within_s=0.1)
        self.assertIn("\nPRM:/r1/c1/c2-Joint2:j2 0.00 deg\n", sensors.text)
        self.assertTrue(repr(sensors).endswith("...)"))
        self.run_.watch("", "IPStack")
        self.run_.connect(54000)
        self.run_.run(0.1)
        texts = [each.text for each in self.run_.watched()]
        self.assertTrue(any(text.startswith("IPStack: TCP ") for text in texts), texts)

    def test_keeps_messages_that_are_watched(self):
        self.run_.watch("OVirtualRobotComm.Sensor", "RCServer", kind="notify")
        self.run_.run(0.32)
        messages = self.run_.watched()
        self.assertEqual(len(messages), 10)
        self.assertTrue(all(message.data for message in messages))
        self.assertEqual(self.run_.watched(), [])

    def test_speaks_the_remote_control(self):
        remote = openr_host.Remote(self.run_)
        self.assertIn("WALK.MTN", remote.motions())
        remote.upload_file(openr_host.default_motion("BOW.MTN"))
        self.assertGreater(remote.play("BOW.MTN"), 0.5)
        remote.wait()
        self.assertEqual(remote.sensors().key_frame, -1)
        with self.assertRaisesRegex(openr_host.RemoteError, "NONE"):
            remote.play("NONE.MTN")

    def test_an_answer_that_comes_late_is_not_that_of_the_next_request(self):
        remote = openr_host.Remote(self.run_)
        connection = remote._connection
        with unittest.mock.patch.object(connection, "receive", lambda count: type(connection).receive(
                connection, count, within_s=0)):
            with self.assertRaises(openr_host.NotMet):
                remote.motions()
        self.assertEqual(len(remote.sensors().joints), len(self.run_.joint_names))
        self.assertIn("WALK.MTN", remote.motions())

    def test_a_port_where_nobody_listens_is_refused(self):
        with self.assertRaisesRegex(openr_host.Refused, "port 4711: no object listens"):
            self.run_.connect(4711)
        with self.assertRaisesRegex(openr_host.NotMet, "has not sent 5 bytes"):
            self.run_.connect(54000).receive(5, within_s=0.1)

    def test_what_is_asked_of_a_closed_connection_is_refused(self):
        connection = self.run_.connect(54000)
        connection.close()
        for ask in (lambda: connection.send(b"x"), lambda: connection.receive(5)):
            with self.assertRaisesRegex(openr_host.Refused, "the connection is closed"):
                ask()

    def test_a_hundred_connections_in_a_row_are_served(self):
        # The robot has the address 10.0.1.100, which no connection may take from it.
        for _ in range(100):
            connection = self.run_.connect(54000)
            self.run_.run(0.016)
            connection.close()
            self.run_.run(0.016)
        self.assertIn("WALK.MTN", openr_host.Remote(self.run_).motions())

    def test_a_request_that_is_too_long_is_refused_and_the_run_goes_on(self):
        connection = self.run_.connect(54000)
        with self.assertRaisesRegex(openr_host.Refused, "at most 67108864 are allowed"):
            connection.send(bytes(64 << 20))
        self.run_.step()

    def test_closed_connections_free_their_places_also_with_unread_answers(self):
        sensors = struct.pack("<2sHBBH", b"RC", 8, 1, 0x30, 0)
        for _ in range(8):
            connection = self.run_.connect(54000)
            self.run_.run(0.016)
            connection.send(sensors * 1000)  # the answers do not fit into the window of 64 KiB
            self.run_.run(1)
            connection.close()
        self.run_.run(5)
        self.assertIn("WALK.MTN", openr_host.Remote(self.run_).motions())

    def test_descriptors_of_a_refused_request_are_closed(self):
        folder = f"/proc/{self.run_._channel.process}/fd"
        before = len(os.listdir(folder))
        with open(os.devnull, "rb") as file:
            for _ in range(5):
                with self.assertRaises(openr_host.Refused):
                    self.run_._channel.ask(b'{"do": "frok"}', descriptors=[file.fileno()])
        self.assertEqual(len(os.listdir(folder)), before)

    def test_makes_motions(self):
        with tempfile.TemporaryDirectory() as folder:
            csv = ("key_frame,time_ms,roll_deg,pitch_deg,yaw_deg," + self.run_.locators["neck_pan"]
                   + "\n0,0,0,0,0,1.5\n1,16,0,0,0,2\n")
            data = self.run_.motion(csv, "a#b")
            self.assertEqual(data[:4], b"OMTN")
            self.assertIn(b"a#b", data)
            file = pathlib.Path(folder, "A.MTN")
            file.write_bytes(data)
            self.assertEqual(file.stat().st_size, len(data))
        with self.assertRaisesRegex(openr_host.Refused, "line 1"):
            self.run_.motion("nonsense")

    def test_shows_what_happens(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.run_.camera()[:8], b"\x89PNG\r\n\x1a\n")
            file = os.path.join(folder, "a.png")
            self.run_.picture(file, view="camera")
            self.assertTrue(os.path.getsize(file) > 100)
            with self.assertRaisesRegex(openr_host.Refused, "nowhere"):
                self.run_.picture("/nowhere/a.png", view="camera")
        self.assertTrue(any("RCServer" in each["name"] for each in self.run_.objects()))
        self.assertTrue(self.run_.object("JointMover")["subjects"])
        self.assertEqual([each for each in self.run_.findings() if each.severity == "error"], [])
        self.assertTrue(self.run_.console())


class LifeTest(unittest.TestCase):
    def test_a_run_begins_asleep_and_without_boot_nothing_goes_on(self):
        with openr_host.Run(body="ideal", boot=False) as run:
            with self.assertRaisesRegex(openr_host.Refused, "not booted"):
                run.step()
            self.assertTrue(math.isnan(run.value("command.neck_pan", float)))  # no object has set it yet
            run.boot()
            run.run(0.1)
            with self.assertRaisesRegex(openr_host.Refused, "booted already"):
                run.boot()

    def test_wrong_options_are_refused(self):
        for wrong in ({"body": "jelly"}, {"robot": "ers999"}, {"stick": "/nowhere"}, {"world": "none.json"},
                      {"network": "out"}, {"robots": 0}, {"battery": "empty"}, {"seed": -1},
                      {"record": "/nowhere/a.rec"}, {"robots": 2, "together": True, "body": "ideal"}):
            with self.assertRaises(openr_host.Refused, msg=wrong):
                openr_host.Run(**wrong)

    def test_a_program_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(openr_host.ProcessError, "no-such-program"):
            openr_host.Run(program="/no-such-program")
        with self.assertRaises(openr_host.ProcessError):
            openr_host.Run(program="/bin/true")

    def test_a_run_that_is_over_says_why(self):
        with openr_host.Run(body="ideal") as run:
            run.until_standing()
            run.press("pause")
            with self.assertRaises(openr_host.RunEnded) as ended:
                run.run(20)
            self.assertEqual(ended.exception.by, "pause")
            with self.assertRaises(openr_host.RunEnded):
                run.step()
            self.assertEqual(run.report()["ended_by"], "pause")
            # The exception keeps the same that the run still says.
            self.assertEqual(ended.exception.report, run.report())
            self.assertEqual(ended.exception.console, run.console())
            self.assertEqual(ended.exception.findings, run.findings())

    def test_a_run_that_is_finished_can_be_read(self):
        with openr_host.Run(body="ideal") as run:
            run.run(1)
            self.assertEqual(run.finish()["virtual_time_s"], 1.0)
            self.assertAlmostEqual(run.value("robots[0].joint.neck_pan"), 0, delta=5)
            with self.assertRaisesRegex(openr_host.Refused, "finished"):
                run.run(1)

    def test_a_closed_run_is_closed(self):
        run = openr_host.Run(body="ideal")
        run.close()
        run.close()
        self.assertTrue(run.closed)
        with self.assertRaisesRegex(openr_host.ProcessError, "closed"):
            run.run(1)

    def test_a_process_that_is_killed_is_noticed(self):
        with openr_host.Run(body="ideal") as run:
            os.kill(run._channel.process, 9)
            with self.assertRaises(openr_host.ProcessError):
                run.run(1)

    def test_a_process_ends_with_its_pipe(self):
        with openr_host.Run(body="ideal") as run:
            popen = run._channel._popen
            run._channel._socket.close()
            self.assertEqual(popen.wait(20), 0)
            run._channel._socket = None

    def test_a_request_that_is_too_long_ends_the_pipe(self):
        with openr_host.Run(body="ideal") as run:
            run._channel._socket.sendall(struct.pack("<II", 0xFFFFFFFF, 0))
            with self.assertRaisesRegex(openr_host.Refused, "at most"):
                run._channel.hear()
            with self.assertRaises((openr_host.ProcessError, AssertionError)):
                run.run(1)

    def test_several_robots_have_values_of_their_own(self):
        with openr_host.Run(body="ode", robots=2, together=True) as run:
            run.run(2)
            run.set_joints({"mouth": -30}, robot=1)
            run.run(1)
            self.assertNotEqual(run.joints(0)["mouth"], run.joints(1)["mouth"])
            self.assertEqual(len(run.read("robots[1].joints")), 18)

    def test_the_host_s_network_is_there_when_asked_for(self):
        with openr_host.Run(body="ideal", network="host") as run:
            run.until_standing()
            self.assertGreater(run.report()["rc_port"], 0)
            with self.assertRaisesRegex(openr_host.Refused, "sockets of this computer"):
                run.fork()
            with self.assertRaisesRegex(openr_host.Refused, "network='inside'"):
                run.connect(54000)


if __name__ == "__main__":
    unittest.main()
