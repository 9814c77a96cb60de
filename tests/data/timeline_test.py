#!/usr/bin/env python3
"""Reads timelines of openr run --timeline with babeltrace2, which knows nothing of this project.

The last line is "N passed, N failed, N skipped".  Skips, with the reason, where babeltrace2 is
missing; where the variable CI is true, that is a failure.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

LINE = re.compile(r"^\[(\d+)\.(\d{9})\] \([^)]*\) (?:\S+ )?(handler_begin|handler_end): \{ (.*) \}$")


def run(folder, *arguments):
    done = subprocess.run([str(BUILD / "bin/openr"), "run", "--rate", "max", "--no-panel", "--body",
                           "ideal", "--for", "2s", "--console", os.devnull, "--timeline",
                           str(folder), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)


def events(folder):
    """Returns a list of (time in ns, name, fields) of the trace in `folder`."""
    done = subprocess.run(["babeltrace2", "--clock-seconds", str(folder)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0 or done.stderr:
        raise AssertionError(f"babeltrace2: status {done.returncode}\n{done.stderr}")
    found = []
    for line in done.stdout.splitlines():
        match = LINE.match(line)
        if match is None:
            raise AssertionError(f"not understood: {line}")
        fields = dict(re.findall(r'(\w+) = ("(?:[^"\\]|\\.)*"|\d+)', match[4]))
        found.append((int(match[1]) * 10**9 + int(match[2]), match[3], fields))
    return found


class TimelineTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="openr-timeline-"))

    def tearDown(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def test_each_handler_has_a_begin_and_an_end(self):
        run(self.folder / "a.ctf")
        found = events(self.folder / "a.ctf")
        begins = {f["message"]: t for t, name, f in found if name == "handler_begin"}
        ends = {f["message"]: (t, f) for t, name, f in found if name == "handler_end"}
        self.assertGreater(len(begins), 200)
        self.assertEqual(begins.keys(), ends.keys())
        for message, (time, fields) in ends.items():
            self.assertEqual(time - begins[message], int(fields["wall_ns"]), message)
            self.assertEqual(fields["cost_ns"], "0")
        times = [t for t, _, _ in found]
        self.assertEqual(times, sorted(times))
        self.assertIn('"JointMover"', {f["object"] for _, _, f in found})

    def test_a_begin_says_what_its_message_says(self):
        run(self.folder / "a.ctf")
        said = {}
        for _, name, fields in events(self.folder / "a.ctf"):
            if name == "handler_begin":
                said.setdefault(fields["entry"].strip('"'), []).append(fields["said"].strip('"'))
        self.assertEqual(set(said["DoInit"]), {"boot"})
        vectors = said["RCServer.Sensor.OSensorFrameVectorData.O (Notify)"]
        self.assertTrue(all(text.startswith("PRM:/r1/c1-Joint2:j1 ") for text in vectors), vectors)
        self.assertTrue(all(len(text) == 120 and text.endswith("...") for text in vectors), vectors)

    def test_costs_are_the_lengths_of_a_run_with_a_cost_file(self):
        cost = self.folder / "a.cost"
        cost.write_text("JointMover DoStart 20000\n")
        run(self.folder / "a.ctf", "--cost", cost)
        ends = [f for _, name, f in events(self.folder / "a.ctf") if name == "handler_end"]
        costs = [f for f in ends if f["cost_ns"] != "0"]
        self.assertEqual([(f["object"], f["cost_ns"]) for f in costs], [('"JointMover"', "20000000")])


    def killed(self, timeline, size):
        """Kills a run when its timeline has `size` bytes."""
        file = timeline / "handlers" if timeline.suffix == ".ctf" else timeline
        process = subprocess.Popen(
            [str(BUILD / "bin/openr"), "run", "--rate", "max", "--no-panel", "--body", "ideal",
             "--console", os.devnull, "--timeline", str(timeline)],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        while not file.exists() or file.stat().st_size < size:
            self.assertIsNone(process.poll())
            time.sleep(0.01)
        process.kill()
        process.wait()

    def test_the_json_of_a_killed_run_is_complete(self):
        self.killed(self.folder / "a.json", 500_000)
        text = (self.folder / "a.json").read_text(errors="replace")
        if not text.endswith("]}\n"):
            # SIGKILL has cut the write of a block: the file ends within a line.
            self.assertFalse(text.endswith("\n"))
            text = text[:text.rindex(",\n")] + "]}\n"
        slices = [event for event in json.loads(text)["traceEvents"] if event["ph"] == "X"]
        self.assertGreater(len(slices), 500)

    def test_the_json_of_a_run_that_is_killed_soon_is_complete(self):
        self.killed(self.folder / "a.json", 1)
        self.assertIn("traceEvents", json.loads((self.folder / "a.json").read_text()))

    def test_a_killed_trace_is_read_to_its_last_whole_event(self):
        self.killed(self.folder / "a.ctf", 100_000)
        self.assertGreater(len(events(self.folder / "a.ctf")), 500)


def main():
    global BUILD
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    BUILD = parser.parse_args().build.resolve()
    if not shutil.which("babeltrace2"):
        is_wrong = os.environ.get("CI") == "true"
        print(f"tests of timelines {'impossible' if is_wrong else 'skipped'}: babeltrace2 is missing "
              "(Debian package babeltrace2)")
        print("0 passed, 1 failed" if is_wrong else "0 passed, 0 failed, 1 skipped")
        return int(is_wrong)
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(TimelineTest)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - failed} passed, {failed} failed")
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
