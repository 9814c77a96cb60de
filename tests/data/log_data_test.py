#!/usr/bin/env python3
"""Runs openr run --log-data and reads the files with readers that know nothing of this project.

MCAP is read with the package of the format's authors, which is among those of the panel's page.
The last line is "N passed, N failed, N skipped".  Skips, with the reason, where node or the packages
are missing; where the variable CI is true, that is a failure.
"""
import argparse
import base64
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PANEL = ROOT / "panel"
READER = pathlib.Path(__file__).with_name("read_mcap.mjs")
PNG = b"\x89PNG\r\n\x1a\n"


def openr(*arguments, ok=True):
    done = subprocess.run([str(BUILD / "bin/openr"), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, stdin=subprocess.DEVNULL, check=False)
    if ok and done.returncode != 0:
        raise AssertionError(f"openr {arguments}: status {done.returncode}\n{done.stderr}")
    return done


def run(file, *arguments):
    return openr("run", "--rate", "max", "--no-panel", "--body", "ideal", "--console", os.devnull,
                 "--log-data", file, *arguments)


def read(file, way="indexed"):
    done = subprocess.run(["node", str(READER), str(PANEL), str(file), way], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


class LogDataTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="openr-data-"))

    def tearDown(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def test_csv_has_a_line_for_each_frame(self):
        file = self.folder / "run.csv"
        run(file, "--for", "4s")
        with file.open(newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.assertEqual(len(rows), 500)
        self.assertEqual(rows[0]["time_s"], "0.008000")
        self.assertEqual(rows[-1]["time_s"], "4.000000")
        last = rows[-1]
        self.assertNotEqual(last["command.LF_j1"], "")
        self.assertAlmostEqual(float(last["measured.LF_j1"]), float(last["joint.LF_j1"]), delta=0.2)
        self.assertGreater(float(last["height_mm"]), 30)
        self.assertIn("sensor.chin", last)
        self.assertEqual(float(last["battery_percent"]), 100)

    def test_values_of_csv_and_mcap_are_those_of_the_report(self):
        report = self.folder / "report.json"
        run(self.folder / "run.csv", "--for", "3s", "--report", report)
        told = json.loads(report.read_text())["robots"][0]
        with (self.folder / "run.csv").open(newline="") as stream:
            last = list(csv.DictReader(stream))[-1]
        self.assertAlmostEqual(float(last["x_m"]), told["base_position_m"][0], delta=1e-6)
        self.assertAlmostEqual(float(last["height_mm"]) / 1e3, told["base_position_m"][2], delta=1e-6)
        self.assertAlmostEqual(float(last["pitch_deg"]), told["base_rpy_deg"][1], delta=1e-3)

    def test_mcap_is_read_by_the_package_of_its_authors(self):
        file = self.folder / "run.mcap"
        run(file, "--for", "3s", "--world", "field-2004.json", "--log-images", "500ms")
        told = read(file)
        self.assertEqual(told["records"], int(told["messages"]))
        self.assertGreaterEqual(told["chunks"], 3)
        self.assertEqual(told["endNs"], "3000000000")
        topics = told["topics"]
        for topic in ("base", "command", "measured", "joint", "sensor"):
            self.assertEqual(topics["/aibo/" + topic]["count"], 375, topic)
            self.assertEqual(topics["/aibo/" + topic]["schemaEncoding"], "jsonschema")
            self.assertEqual(topics["/aibo/" + topic]["encoding"], "json")
        joints = topics["/aibo/joint"]
        self.assertEqual(set(joints["last"]) - {"timestamp"},
                         set(joints["schemaText"]["properties"]) - {"timestamp"})
        self.assertEqual(joints["first"]["timestamp"], {"sec": 0, "nsec": 8000000})
        self.assertEqual(topics["/tf"]["schema"], "foxglove.FrameTransforms")
        frames = [each["child_frame_id"] for each in topics["/tf"]["last"]["transforms"]]
        self.assertIn("thing/ball", frames)
        self.assertTrue(any(frame.startswith("aibo/") for frame in frames), frames)
        entities = topics["/aibo/shapes"]["first"]["entities"]
        self.assertTrue({entity["frame_id"] for entity in entities} <= set(frames))
        self.assertTrue(topics["/world"]["first"]["entities"][0]["cubes"])
        camera = topics["/aibo/camera"]
        self.assertEqual(camera["schema"], "foxglove.CompressedImage")
        self.assertIn(camera["count"], (5, 6))
        self.assertTrue(base64.b64decode(camera["last"]["data"]).startswith(PNG))

    def test_mcap_read_from_its_beginning_has_the_same(self):
        file = self.folder / "run.mcap"
        run(file, "--for", "2s", "--log-images", "0s")
        stream, indexed = read(file, "stream"), read(file)
        self.assertTrue(stream["hasEnd"])
        self.assertEqual(stream["why"], "")
        self.assertEqual(stream["records"], indexed["records"])
        self.assertNotIn("/aibo/camera", stream["topics"])

    def test_findings_and_inputs_are_topics(self):
        events = self.folder / "day.events"
        events.write_text("500ms press chin for 300ms\n")
        file = self.folder / "run.mcap"
        run(file, "--for", "1s", "--battery", "5%", "--events", events)
        topics = read(file)["topics"]
        self.assertEqual(topics["/inputs"]["first"]["message"], "press chin for 300ms")
        self.assertEqual(topics["/inputs"]["schema"], "foxglove.Log")
        self.assertIn("battery", topics["/findings"]["first"]["message"])

    def test_a_finding_names_its_message_and_what_that_said(self):
        stick = self.folder / "stick"
        objects, conf = stick / "OPEN-R/MW/OBJS", stick / "OPEN-R/MW/CONF"
        for folder in (objects, conf, stick / "OPEN-R/MW/DATA/P"):
            folder.mkdir(parents=True)
        shutil.copy(BUILD / "images/TROUBLE.BIN", objects)
        (conf / "OBJECT.CFG").write_text("/MS/OPEN-R/MW/OBJS/TROUBLE.BIN\n")
        (conf / "CONNECT.CFG").write_text("")
        (stick / "OPEN-R/MW/DATA/P/TROUBLE.TXT").write_text("nan")
        file = self.folder / "run.mcap"
        run(file, "--for", "1s", "--stick", stick)
        message = read(file)["topics"]["/findings"]["first"]["message"]
        self.assertRegex(message, r"made NaN.* \(message [0-9]+: boot\)$")

    def test_two_robots_have_topics_of_their_own(self):
        file = self.folder / "run.mcap"
        run(file, "--for", "1s", "--robots", "2", "--log-images", "0s")
        topics = read(file)["topics"]
        self.assertEqual(topics["/aibo0/joint"]["count"], topics["/aibo1/joint"]["count"])
        self.assertNotIn("/aibo/joint", topics)

    def test_file_of_a_killed_run_has_whole_records(self):
        file = self.folder / "run.mcap"
        with subprocess.Popen([str(BUILD / "bin/openr"), "run", "--rate", "max", "--no-panel",
                               "--body", "ideal", "--console", os.devnull, "--log-data", str(file)],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              stdin=subprocess.DEVNULL) as process:
            deadline = time.monotonic() + 120
            while not file.exists() or file.stat().st_size < 3_000_000:
                self.assertIsNone(process.poll())
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.01)
            process.send_signal(signal.SIGKILL)
        told = read(file, "stream")
        self.assertFalse(told["hasEnd"])
        self.assertGreater(told["topics"]["/aibo/joint"]["count"], 100)
        listed = openr("plot", file, "--list")
        self.assertIn("ends without a summary", listed.stderr)
        self.assertIn("joint.LF_j1\n", listed.stdout)

    def test_replay_writes_what_the_run_wrote(self):
        recording, first, second = (self.folder / name for name in ("run.rec", "a.csv", "b.csv"))
        run(first, "--for", "2s", "--record", recording)
        openr("replay", recording, "--log-data", second)
        self.assertEqual(first.read_bytes(), second.read_bytes())


def main():
    global BUILD
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    BUILD = parser.parse_args().build.resolve()
    why = ""
    if not shutil.which("node"):
        why = "node is missing (Debian package nodejs)"
    elif not (PANEL / "node_modules/@mcap/core").exists():
        why = "the packages of the page are not installed (target panel_page)"
    if why:
        is_wrong = os.environ.get("CI") == "true"
        print(f"tests of --log-data {'impossible' if is_wrong else 'skipped'}: {why}")
        print("0 passed, 1 failed" if is_wrong else "0 passed, 0 failed, 1 skipped")
        return int(is_wrong)
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(LogDataTest)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - failed} passed, {failed} failed")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
