#!/usr/bin/env python3
"""Reads timelines of openr run --timeline with programs that know nothing of this project.

Those in CTF are read by babeltrace2; those in JSON are checked by jsonschema, with the schema of
the trace event format beside this file.  The last line is "N passed, N failed, N skipped".  Tests
whose program or module is missing are skipped, with the reason; where the variable CI is true, that
is a failure.
"""
import argparse
import collections
import copy
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

try:
    import jsonschema
except ImportError:
    jsonschema = None

SCHEMA = pathlib.Path(__file__).with_name("trace_events.schema.json")
LINE = re.compile(r"^\[(\d+)\.(\d{9})\] \([^)]*\) (?:\S+ )?(handler_begin|handler_end): \{ (.*) \}$")


def openr(*arguments):
    """Returns what the program prints on standard output."""
    done = subprocess.run([str(BUILD / "bin/openr"), *map(str, arguments)], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout


def run(folder, *arguments):
    openr("run", "--rate", "max", "--no-panel", "--body", "ideal", "--for", "2s", "--console",
          os.devnull, "--timeline", folder, *arguments)


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
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def need(self, is_there, name, package):
        """Skips the test if `name`, which the Debian package brings, is not there."""
        if is_there:
            return
        reason = f"{name} is missing (Debian package {package})"
        if os.environ.get("CI") == "true":
            self.fail(reason)
        self.skipTest(reason)

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


class CtfTest(TimelineTest):
    def setUp(self):
        super().setUp()
        self.need(shutil.which("babeltrace2"), "babeltrace2", "babeltrace2")

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

    def test_a_killed_trace_is_read_to_its_last_whole_event(self):
        self.killed(self.folder / "a.ctf", 100_000)
        self.assertGreater(len(events(self.folder / "a.ctf")), 500)


def of_kind(document, kind):
    return [event for event in document["traceEvents"] if event["ph"] == kind]


def problems(document):
    """Returns what the schema finds wrong with the JSON of a timeline."""
    checker = jsonschema.Draft7Validator(json.loads(SCHEMA.read_text()))
    return [f"{list(error.path)}: {error.message}" for error in checker.iter_errors(document)]


class JsonTest(TimelineTest):
    def timeline(self, *arguments):
        run(self.folder / "a.json", *arguments)
        return json.loads((self.folder / "a.json").read_text())

    def need_jsonschema(self):
        self.need(jsonschema, "the Python module jsonschema", "python3-jsonschema")

    def test_timelines_are_trace_events(self):
        self.need_jsonschema()
        recording = self.folder / "a.rec"
        for arguments in [], ["--cost", "ers210.cost", "--robots", "2"], ["--record", recording]:
            self.assertEqual(problems(self.timeline(*arguments)), [], arguments)
        text = openr("trace", recording, "--format", "perfetto")
        self.assertEqual(problems(json.loads(text)), [])

    def test_the_schema_refuses_what_is_no_trace_event(self):
        self.need_jsonschema()
        good = self.timeline()
        good["traceEvents"] = [of_kind(good, kind)[0] for kind in "XsfM"]
        self.assertEqual(problems(good), [])
        slice_, begin, end, name = range(4)
        for event, field, value in ((slice_, "ph", "Y"), (slice_, "ts", "0"), (slice_, "dur", -1),
                                    (slice_, "length", 1), (slice_, "args", {}), (begin, "id", 1.5),
                                    (begin, "bp", "e"), (end, "bp", "s"), (end, "tid", "RCServer"),
                                    (name, "name", "name"), (name, "args", {"name": 1})):
            bad = copy.deepcopy(good)
            bad["traceEvents"][event][field] = value
            self.assertNotEqual(problems(bad), [], (event, field, value))
        for event, field in ((slice_, "dur"), (begin, "id"), (end, "cat"), (name, "pid")):
            bad = copy.deepcopy(good)
            del bad["traceEvents"][event][field]
            self.assertNotEqual(problems(bad), [], (event, field))

    def test_each_arrow_leads_from_the_slice_of_the_sender_to_that_of_its_message(self):
        document = self.timeline()
        slices, cause = collections.defaultdict(list), {}
        for event in of_kind(document, "X"):
            message = event["args"]["message"]
            slices[event["pid"], event["tid"]].append((event["ts"], event["dur"], message))
            cause[message] = event["args"]["cause"]

        def messages_at(end):
            """Messages of the slices in which this end of an arrow is drawn."""
            return [message for at, length, message in slices[end["pid"], end["tid"]]
                    if at <= end["ts"] <= at + length]

        begins, ends = of_kind(document, "s"), of_kind(document, "f")
        # A message whose sender is the system, such as the boot of an object, has no arrow.
        drawn = [message for message in cause if cause[message] in cause]
        self.assertGreater(len(drawn), 200)
        self.assertEqual(sorted(arrow["id"] for arrow in begins), sorted(drawn))
        self.assertEqual(sorted(arrow["id"] for arrow in ends), sorted(drawn))
        for arrow in begins:
            self.assertIn(cause[arrow["id"]], messages_at(arrow), arrow)
        for arrow in ends:
            self.assertIn(arrow["id"], messages_at(arrow), arrow)

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

def main():
    global BUILD
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    BUILD = parser.parse_args().build.resolve()
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules[__name__])
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2).run(suite)
    failed = len(result.failures) + len(result.errors)
    skipped = len(result.skipped)
    print(f"{result.testsRun - failed - skipped} passed, {failed} failed" +
          (f", {skipped} skipped" if skipped else ""))
    return int(failed > 0)


if __name__ == "__main__":
    sys.exit(main())
