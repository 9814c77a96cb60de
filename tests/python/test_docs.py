"""Checks that the documentation of openr_host is true and up to date."""
import contextlib
import io
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import find_walk

try:
    import ipykernel  # noqa: F401, the kernel that nbclient starts
    import nbclient
    import nbformat
except ImportError:
    nbclient = None

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LISTING = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@contextlib.contextmanager
def in_empty_folder():
    before = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            yield pathlib.Path(folder)
        finally:
            os.chdir(before)


class DocsTest(unittest.TestCase):
    def test_the_listings_of_the_page_run(self):
        text = (ROOT / "docs/python.md").read_text()
        names = {}
        with in_empty_folder(), contextlib.redirect_stdout(io.StringIO()):
            subprocess.run([os.environ["OPENR_HOST_PROGRAM"], "new", "Greeter"], check=True,
                           capture_output=True)  # the page says so before its listing
            for match in LISTING.finditer(text):
                line = text[:match.start()].count("\n") + 1
                exec(compile("\n" * line + match[1], "docs/python.md", "exec"), names)
        self.assertGreaterEqual(len(LISTING.findall(text)), 8)

    def test_commands_and_their_table_are_up_to_date(self):
        done = subprocess.run(
            [sys.executable, str(ROOT / "tools/python_commands.py"), "--check", "--program",
             os.environ["OPENR_HOST_PROGRAM"]], stdout=subprocess.PIPE, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_the_page_names_every_flag_of_openr_run(self):
        said = subprocess.run([os.environ["OPENR_HOST_PROGRAM"], "run", "--help"], check=True,
                              stdout=subprocess.PIPE, text=True).stdout
        flags = set(re.findall(r"^  (--?[a-z][a-z0-9-]*)(?!\S)", said, re.MULTILINE)) - {"--help", "--help-all"}
        self.assertIn("--leaks", flags)
        table = (ROOT / "docs/python.md").read_text().split("| of `openr run` | in Python |")[1].split("\n\n")[0]
        column = "".join(row.split("|")[1] for row in table.splitlines()[2:])
        named = set(re.findall(r"`(--?[a-z][a-z0-9-]*)`", column))
        self.assertEqual(named, flags)

    def test_every_command_is_used_by_the_module(self):
        described = subprocess.run([os.environ["OPENR_HOST_PROGRAM"], "serve", "--describe"],
                                   check=True, stdout=subprocess.PIPE).stdout
        used = (ROOT / "python/openr_host/run.py").read_text()
        used += (ROOT / "python/openr_host/_channel.py").read_text()
        for command in json.loads(described)["commands"]:
            name = command["name"]
            self.assertTrue(f"_commands.{name}(" in used or f'"do": "{name}"' in used, name)

    def test_the_notebook_runs(self):
        notebook = json.loads((ROOT / "examples/python/commanded_measured.ipynb").read_text())
        code = ["".join(cell["source"]) for cell in notebook["cells"] if cell["cell_type"] == "code"]
        with in_empty_folder() as folder:
            names = {"__name__": "__main__"}
            os.environ["MPLBACKEND"] = "Agg"
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                for number, cell in enumerate(code):
                    exec(compile(cell, f"cell {number}", "exec"), names)
            self.assertIn("LF_j1", out.getvalue())
            self.assertGreater(len(names["rows"]), 30)
            self.assertEqual(list(folder.glob("*.png")) != [], names["pyplot"] is not None)

    @unittest.skipIf(nbclient is None, "nbclient and ipykernel are not installed")
    def test_the_notebook_runs_in_jupyter(self):
        notebook = nbformat.read(ROOT / "examples/python/commanded_measured.ipynb", as_version=4)
        nbformat.validate(notebook)
        with in_empty_folder():
            nbclient.NotebookClient(notebook, timeout=300).execute()
        said = "".join(output.get("text", "") for cell in notebook.cells if cell.cell_type == "code"
                       for output in cell.outputs)
        self.assertIn("frames", said)
        self.assertIn("LF_j1: follows after", said)

    @unittest.skipIf(shutil.which("cmake") is None, "cmake is not installed")
    def test_an_installed_module_is_complete(self):
        with in_empty_folder() as folder:
            subprocess.run(["cmake", "--install", os.environ["OPENR_HOST_BUILD"], "--component",
                            "python", "--prefix", str(folder)], check=True, stdout=subprocess.DEVNULL)
            module = folder / "lib/python3/dist-packages"
            text = "import openr_host\nwith openr_host.Run(body='ideal') as run: run.run(0.1)"
            subprocess.run([sys.executable, "-c", text], check=True,
                           env={**os.environ, "PYTHONPATH": str(module)})
            self.assertTrue((module / "openr_host/py.typed").exists())

    def checked_types(self, folder, *arguments):
        return subprocess.run(["mypy", "--cache-dir", str(folder / "cache"), *arguments], stdout=subprocess.PIPE,
                              text=True, env={**os.environ, "MYPYPATH": str(ROOT / "python")})

    @unittest.skipIf(shutil.which("mypy") is None, "mypy is not installed")
    def test_types_are_right(self):
        with in_empty_folder() as folder:
            done = self.checked_types(folder, "--config-file", str(ROOT / "python/mypy.ini"), str(ROOT / "python/openr_host"))
        self.assertEqual(done.returncode, 0, done.stdout)

    @unittest.skipIf(shutil.which("mypy") is None, "mypy is not installed")
    def test_a_program_can_be_checked_strictly_without_a_configuration(self):
        # --no-site-packages hides gymnasium and numpy.
        with in_empty_folder() as folder:
            program = folder / "program.py"
            program.write_text("import openr_host\n"
                               "def height(run: openr_host.Run) -> float:\n"
                               "    return run.value('height_mm', float)\n"
                               "def state(run: openr_host.Run) -> str:\n"
                               "    return run.value('objects.JointMover.state', str)\n")
            done = self.checked_types(folder, "--strict", "--config-file", "", "--no-site-packages", str(program))
            self.assertEqual(done.returncode, 0, done.stdout)
            program.write_text(program.read_text().replace("float)", "str)"))
            done = self.checked_types(folder, "--strict", "--config-file", "", "--no-site-packages", str(program))
        self.assertIn('Incompatible return value type (got "str", expected "float")', done.stdout)


class WalkTest(unittest.TestCase):
    def test_help_names_no_path_of_the_checkout(self):
        done = subprocess.run([sys.executable, str(ROOT / "examples/python/find_walk.py"), "--help"],
                              stdout=subprocess.PIPE, text=True)
        self.assertIn("find_walk.py -o FOLDER", done.stdout)
        self.assertNotIn("examples/python", done.stdout)

    RESULT = {"slowest_mm_s": 120.0, "times_as_fast": 1.5, "shipped_mm_s": 80.0, "good": True}

    def test_a_winner_that_is_fast_enough_is_a_success(self):
        line, status = find_walk.verdict(self.RESULT, 1.5)
        self.assertEqual(line, "120.0 mm/s, 1.50 times the walk of the stick (80.0 mm/s); at least 1.5 times: yes; "
                         "upright, straight and within limits: yes")
        self.assertEqual(status, 0)

    def test_a_winner_that_is_too_slow_is_a_failure(self):
        line, status = find_walk.verdict({**self.RESULT, "times_as_fast": 1.499}, 1.5)
        self.assertIn("at least 1.5 times: no; upright", line)
        self.assertEqual(status, 1)

    def test_a_winner_that_is_not_upright_is_a_failure(self):
        line, status = find_walk.verdict({**self.RESULT, "good": False}, 1.5)
        self.assertIn("upright, straight and within limits: no", line)
        self.assertEqual(status, 1)

    def test_a_number_of_generations_takes_as_long_as_it_takes(self):
        self.assertEqual(find_walk.limits_of(40, None), (40, math.inf))
        self.assertEqual(find_walk.limits_of(0, None), (math.inf, 570))
        self.assertEqual(find_walk.limits_of(40, 1), (40, 57))

    def test_a_short_search_improves_the_walk(self):
        with in_empty_folder() as folder:
            done = subprocess.run(
                [sys.executable, str(ROOT / "examples/python/find_walk.py"), "-o", "walk",
                 "--generations", "2", "--population", "16"],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=900)
            result = json.loads((folder / "walk/walk.json").read_text())
            line, status = find_walk.verdict(result, 1.5)
            self.assertEqual((done.stdout.splitlines()[-1], done.returncode), (line, status))
            self.assertTrue(result["keeps_limits"])
            self.assertGreater(result["search_mm_s"], result["begun_mm_s"] + 5)
            # A seed decides conditions under which the dog walks in another way.
            self.assertEqual(len({walk["speed_mm_s"] for walk in result["shipped_walks"]}), 3)
            self.assertEqual(len({json.dumps(each) for each in result["conditions"].values()}), 3)
            self.assertEqual((folder / "walk/GO.MTN").read_bytes()[:4], b"OMTN")
            self.assertIn("polyline", (folder / "walk/curve.svg").read_text())


if __name__ == "__main__":
    unittest.main()
