#!/usr/bin/env python3
"""tools/coverage.py: which failing tests of the build with counters are failures.  The last line is
"N passed, N failed"."""
import contextlib
import io
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import coverage  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

# A test program with the tests $tests, of which $failing fail; it prints as the programs of the tests do.
PROGRAM = """#!/bin/sh
{before}
filter=${{1#--gtest_filter=}}
failed=0 passed=0
for test in {tests}; do
  case "$filter" in ''|"$test") ;; *) continue ;; esac
  case " {failing} " in
    *" $test "*) failed=$((failed + 1)); echo "[  FAILED  ] $test" ;;
    *) passed=$((passed + 1)); echo "[       OK ] $test (0 ms)" ;;
  esac
done
echo "$passed passed, $failed failed"
[ $failed -eq 0 ]
"""


def write(folder, name, failing="", before=""):
    file = folder / "bin" / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(PROGRAM.format(tests="A.One A.Two A.Three A.Four", failing=failing, before=before))
    file.chmod(0o755)


def check(name, wanted, here, other="", before=""):
    """Checks what is wrong if the tests `here` fail in the build with counters, and `other` in the other one."""
    with tempfile.TemporaryDirectory() as folder:
        builds = Path(folder, "coverage"), Path(folder, "release")
        write(builds[0], "runtime_tests", here, before)
        write(builds[0], "kit_tests", "A.One A.Two A.Three")  # left out
        if other is not None:
            write(builds[1], "runtime_tests", other)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            wrong = coverage.run_tests(*builds)
        verdict(name, len(wrong) == len(wanted) and all(word in line for word, line in zip(wanted, wrong)),
                f"{wrong}\n{said.getvalue()}")


def main():
    check("tests that pass are good", [], "")
    check("two tests may fail that pass in the other build", [], "A.One A.Three")
    check("a third one may not", ["3 tests pass in"], "A.One A.Two A.Three")
    check("a test that fails in both builds is a failure", ["runtime_tests: A.Two"], "A.One A.Two", "A.Two")
    check("a test that the other build lacks is a failure", ["runtime_tests: A.One"], "A.One", None)
    check("a program that crashes is a failure", ["runtime_tests: fails, and names no test"], "", before="kill -9 $$")
    return finish()


if __name__ == "__main__":
    sys.exit(main())
