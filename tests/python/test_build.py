"""build: what `openr build` makes of a folder, and what its exception says."""
import contextlib
import io
import pathlib
import subprocess
import tempfile
import unittest

import openr_host
from openr_host._channel import find_program


class BuildTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="a stick ")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()

    def new(self, name, folder=None):
        """Makes an object, and returns its folder."""
        folder = folder or self.root / name
        subprocess.run([find_program(), "new", name, str(folder)], check=True, capture_output=True)
        return folder

    def test_the_stick_of_a_folder_is_built_and_runs(self):
        folder = self.new("Greeter")
        stick = openr_host.build(folder)
        self.assertEqual(stick, folder / "MS")
        with openr_host.Run(stick, body="ideal") as run:
            self.assertIn("greeter", [each["name"] for each in run.objects()])

    def test_the_stick_goes_to_another_folder(self):
        output = self.root / "other"
        self.assertEqual(openr_host.build(self.new("Greeter"), output=output), output)
        self.assertTrue((output / "OPEN-R/MW/OBJS/GREETER.BIN").exists())

    def test_a_wrong_source_raises_with_the_lines_of_the_compiler(self):
        folder = self.new("Greeter")
        source = folder / "Greeter/Greeter.cc"
        source.write_text(source.read_text() + "int wrong = undeclared;\n")
        line = len(source.read_text().splitlines())
        with self.assertRaises(openr_host.BuildFailed) as failed:
            openr_host.build(folder, jobs=1)
        self.assertRegex(str(failed.exception), rf"Greeter\.cc:{line}:\d+: error: 'undeclared' was not declared")
        self.assertIn("GREETER.BIN was not built", str(failed.exception))

    def test_warnings_are_printed_with_echo(self):
        folder = self.new("Greeter")
        source = folder / "Greeter/Greeter.cc"
        source.write_text('#warning "heard"\n' + source.read_text())
        for echo in (False, True):
            source.touch()
            with contextlib.redirect_stderr(io.StringIO()) as said:
                openr_host.build(folder, echo=echo)
            self.assertEqual("heard" in said.getvalue(), echo)

    def test_a_folder_that_is_not_there_is_named(self):
        with self.assertRaisesRegex(openr_host.BuildFailed, "nothing: is no folder"):
            openr_host.build(self.root / "nothing")

    def test_a_variant_that_there_is_not_is_refused(self):
        with self.assertRaisesRegex(openr_host.Refused, "no variant 'fast'; there are debug, sanitize, coverage"):
            openr_host.build(self.root, "fast")

    def test_several_sticks_are_named(self):
        for name in ("Greeter", "Listener"):
            self.new(name, self.root / "both" / name)
        with self.assertRaisesRegex(openr_host.Error, "2 sticks have been built: .*Greeter/MS, .*Listener/MS"):
            openr_host.build(self.root / "both")


if __name__ == "__main__":
    unittest.main()
