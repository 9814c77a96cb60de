"""Objects that crash, or do not return: the exception says which object, and the recording is good."""
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

import openr_host
from openr_host._channel import find_program

CALM = "if (vectors++ == 0) {"
# A global object whose constructor ends the process as the file EARLY.TXT of the stick says.
EARLY = """
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct Early {
    Early()
    {
        char word[16] = "";
        FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/EARLY.TXT", "r");
        if (file == 0) return;
        if (fscanf(file, "%15s", word) != 1) word[0] = 0;
        fclose(file);
        if (strcmp(word, "crash") == 0) *(volatile int*)0 = 1;
        if (strcmp(word, "abort") == 0) abort();
        if (strcmp(word, "exit") == 0) exit(4);
        for (volatile int i = 0; strcmp(word, "hang") == 0;) i++;
    }
};

static Early early;
"""


class EndingTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = pathlib.Path(cls.folder.name)
        cls.sticks = {}
        for name, does, does_early in (
                ("Crasher", "if (vectors == 20) *(volatile int*)0 = 1;", ""),
                ("Sleeper", "if (vectors == 20) for (volatile int i = 0;;) i++;", ""),
                ("Divider", "if (vectors == 20) { volatile double i = 0; i = i / i; }", ""),
                ("Starter", "", EARLY)):
            openr = find_program()
            subprocess.run([openr, "new", name, str(cls.root / name)], check=True,
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            source = cls.root / name / name / f"{name}.cc"
            source.write_text(source.read_text().replace(CALM, f"{does}\n    {CALM}") + does_early)
            cls.sticks[name] = openr_host.build(cls.root / name)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_a_crash_ends_the_run_with_its_record(self):
        record = self.root / "crash.rec"
        self.addCleanup((self.sticks["Crasher"] / "OPEN-R/EMON.LOG").unlink)
        with openr_host.Run(self.sticks["Crasher"], body="ideal", record=record) as run:
            with self.assertRaises(openr_host.RunEnded) as ended:
                run.run(10)
        self.assertEqual(ended.exception.by, "crash")
        self.assertIn("Crasher", ended.exception.why)
        self.assertTrue(run.closed)
        # The recording goes as far as the crash, so its replay crashes at the same place.
        with self.assertRaisesRegex(openr_host.Error, r"(?s)EXCEPTION SIGSEGV.*OBJECT crasher, "):
            openr_host.replay(record, self.sticks["Crasher"])
        with self.assertRaises(openr_host.ProcessError):
            run.step()

    def check_last_words(self, name, **parameters):
        """Lets the object of a stick end its run, and compares what the exception keeps."""
        with openr_host.Run(self.sticks[name], body="ideal", **parameters) as run:
            run.run(0.6)
            before = run.console()
            with self.assertRaises(openr_host.RunEnded) as ended:
                run.run(10)
            with self.assertRaises(openr_host.ProcessError):
                run.findings()
        kept = ended.exception
        self.assertEqual(kept.console, before)
        self.assertIn(f"{name} has started", kept.console)
        self.assertEqual((kept.report["ended_by"], kept.report["ended_why"]), (kept.by, kept.why))
        self.assertGreater(kept.report["virtual_time_s"], 0.6)
        finding = kept.findings[-1]
        self.assertEqual((finding.severity, finding.object), ("error", name.lower()))
        self.assertIn(finding.text, kept.why)
        self.assertTrue(finding.said.startswith("PRM:/r1/c1-Joint2:j1 "), finding)

    def test_after_a_crash_findings_console_and_report_are_kept(self):
        self.addCleanup((self.sticks["Crasher"] / "OPEN-R/EMON.LOG").unlink)
        self.check_last_words("Crasher")

    def test_after_an_endless_handler_findings_console_and_report_are_kept(self):
        self.check_last_words("Sleeper", handler_limit_s=0.3)

    def test_objects_built_with_sanitizers_run(self):
        folder = self.root / "Checked"
        subprocess.run([find_program(), "new", "Checked", folder], check=True, capture_output=True)
        with openr_host.Run(openr_host.build(folder, "sanitize"), body="ideal") as run:
            self.assertIn("checked", [each["name"] for each in run.objects()])

    def test_standard_error_says_what_the_message_of_a_crash_said(self):
        self.addCleanup((self.sticks["Crasher"] / "OPEN-R/EMON.LOG").unlink)
        with tempfile.TemporaryFile() as heard:
            before = os.dup(2)
            os.dup2(heard.fileno(), 2)  # standard error of the process of the run
            try:
                with openr_host.Run(self.sticks["Crasher"], body="ideal") as run:
                    with self.assertRaises(openr_host.RunEnded):
                        run.run(10)
            finally:
                os.dup2(before, 2)
                os.close(before)
            heard.seek(0)
            text = heard.read().decode()
        self.assertRegex(text, r"\nMESSAGE notification from OVirtualRobotComm, \d+ bytes\nSTACK\n")
        self.assertRegex(text, r"\nopenr: message \d+: PRM:/r1/c1-Joint2:j1 ")

    def test_a_finding_says_what_the_message_said(self):
        with openr_host.Run(self.sticks["Divider"], body="ideal") as run:
            run.run(2)
            finding = next(each for each in run.findings() if "made NaN" in each.text)
        self.assertGreater(finding.message, 0)
        self.assertTrue(finding.said.startswith("PRM:/r1/c1-Joint2:j1 "), finding)

    def test_a_handler_that_does_not_return_ends_the_run(self):
        with openr_host.Run(self.sticks["Sleeper"], body="ideal", handler_limit_s=0.3) as run:
            with self.assertRaises(openr_host.RunEnded) as ended:
                run.run(10)
        self.assertEqual(ended.exception.by, "handler-limit")
        self.assertIn("Sleeper", ended.exception.why)

    def test_a_constructor_that_ends_the_process_is_the_answer_to_the_start(self):
        stick = self.sticks["Starter"]
        record, data = stick / "OPEN-R/EMON.LOG", stick / "OPEN-R/MW/DATA/P"
        data.mkdir(parents=True, exist_ok=True)
        for word, by, text in (("crash", "crash", "SIGSEGV"),
                               ("abort", "crash", "a constructor of a global object has called abort()"),
                               ("exit", "crash", "a constructor of a global object has called exit()"),
                               ("hang", "handler-limit", "0.3 s of processor time (handler_limit_s)")):
            with self.subTest(word):
                (data / "EARLY.TXT").write_text(word)
                with self.assertRaises(openr_host.RunEnded) as ended:
                    openr_host.Run(stick, body="ideal", handler_limit_s=0.3)
                kept = ended.exception
                self.assertEqual(kept.by, by)
                self.assertIn(text, kept.why)
                self.assertIn("constructors of its globals", kept.why)
                finding, = kept.findings
                self.assertEqual((finding.severity, finding.object), ("error", "starter"))
                self.assertIn(finding.text, kept.why)
                self.assertEqual((kept.console, kept.report["ended_by"]), ([], by))
                self.assertEqual(record.exists(), by == "crash")
                record.unlink(missing_ok=True)
        (data / "EARLY.TXT").unlink()
        with openr_host.Run(stick, body="ideal") as run:  # the stick is as good as before
            run.run(0.2)

    def test_a_crash_in_a_copy_leaves_the_original_alone(self):
        with openr_host.Run(self.sticks["Crasher"], body="ideal") as run:
            run.run(0.2)
            copy = run.fork()
            with self.assertRaises(openr_host.RunEnded) as ended:
                copy.run(10)
            self.assertEqual(ended.exception.by, "crash")
            self.assertFalse((self.sticks["Crasher"] / "OPEN-R/EMON.LOG").exists())
            run.run(0.2)
            self.assertAlmostEqual(run.time_s, 0.4)

    def test_a_hanging_copy_is_ended_too(self):
        with openr_host.Run(self.sticks["Sleeper"], body="ideal", handler_limit_s=0.3) as run:
            with run.fork() as copy, self.assertRaises(openr_host.RunEnded) as ended:
                copy.run(10)
            self.assertEqual(ended.exception.by, "handler-limit")


class LastWordsTest(unittest.TestCase):
    """Checks the exceptions that the module makes of the last messages of a process."""

    CRASH = {"error": "EXCEPTION SIGSEGV", "kind": "ended", "ended": {"by": "crash", "why": "walker: crash"}}
    FINDING = {"severity": "error", "robot": 0, "object": "walker", "time_s": 1.5, "message": 7, "said": "boot",
               "count": 1, "text": "crash"}
    WORDS = {"findings": [FINDING], "console": ["hello"], "report": {"ended_by": "crash"}}

    def ended_by(self, *messages, then=""):
        """Returns the exception when a process answers the first request with these messages, all at once,
        does what the line `then` of Python says, and ends."""
        texts = [json.dumps(each).encode() for each in messages]
        answer = b"".join(struct.pack("<II", len(text), 0) + text for text in texts)
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder, "openr")
            program.write_text(f"#!{sys.executable}\nimport os\nos.read(0, 1 << 16)\nos.write(1, {answer!r})\n"
                               f"{then}\n")
            program.chmod(0o755)
            with self.assertRaises(openr_host.RunEnded) as ended:
                openr_host.Run(program=str(program))
        self.assertEqual((ended.exception.by, ended.exception.why), ("crash", "walker: crash"))
        return ended.exception

    def test_last_words_that_come_with_the_answer_are_kept(self):
        ended = self.ended_by(self.CRASH, self.WORDS)
        self.assertEqual(ended.findings, [openr_host.Finding("error", "walker", 1.5, "crash", 7, "boot")])
        self.assertEqual((ended.console, ended.report), (["hello"], {"ended_by": "crash"}))

    def test_a_process_that_cannot_say_more_leaves_them_empty(self):
        ended = self.ended_by(self.CRASH)
        self.assertEqual((ended.findings, ended.console, ended.report), ([], [], {}))

    def test_words_that_break_off_are_left_out(self):
        ended = self.ended_by(self.CRASH, then="os.write(1, b'\\x09\\0\\0\\0\\0\\0\\0\\0{')")
        self.assertEqual((ended.findings, ended.console, ended.report), ([], [], {}))

    def test_they_are_awaited_until_the_process_ends_and_no_longer(self):
        # The child of the process keeps the pipe.  It goes on until the pipe is closed, and would send a
        # message if that did not happen for a minute.
        words = json.dumps(self.WORDS).encode()
        message = struct.pack("<II", len(words), 0) + words
        ended = self.ended_by(self.CRASH, then="import select\nif os.fork() == 0 and not "
                              f"select.select([0], [], [], 60)[0]: os.write(1, {message!r})")
        self.assertEqual((ended.findings, ended.console, ended.report), ([], [], {}))


if __name__ == "__main__":
    unittest.main()
