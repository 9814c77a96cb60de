#!/usr/bin/env python3
"""tests/examples/run_examples.py: which hashes it compares and records, with examples that only pretend.  The last
line is "N passed, N failed"."""
import contextlib
import io
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tests/examples")]
import run_examples  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

HEAD = "# Arguments and hash of the trace of each run of the examples (run_examples.py).\n"
RECORDED = HEAD + "Ears --for 2s  01\nEars --for 2s --seed 2  02\nTone --for 2s  03\n"
# The results of run() for examples that are as recorded: complaints, skipped parts and hashes.
AS_RECORDED = {"Ears": ([], [], ["Ears --for 2s  01", "Ears --for 2s --seed 2  02"]),
               "Tone": ([], [], ["Tone --for 2s  03"])}


def main_of(outcomes, *flags, recorded=RECORDED, live=()):
    """Runs main() with examples whose run() returns `outcomes`.

    Returns its status, its text and what is in hashes.txt after it.
    """
    with tempfile.TemporaryDirectory() as folder:
        run_examples.HASHES = Path(folder, "hashes.txt")
        run_examples.HASHES.write_text(recorded)
        run_examples.EXAMPLES = Path(folder, "examples")
        for name in outcomes:
            (run_examples.EXAMPLES / name).mkdir(parents=True)
        run_examples.checks = lambda: dict.fromkeys(sorted(outcomes))
        run_examples.is_live = lambda name: name in live
        run_examples.run = lambda openr, name, check, scratch, apart: outcomes[name]
        sys.argv = ["run_examples.py", "--build", "build", *flags]
        with contextlib.redirect_stdout(io.StringIO()) as text:
            status = run_examples.main()
        return status, text.getvalue(), run_examples.HASHES.read_text()


def check(name, outcomes, *flags, status, says, file=RECORDED, **options):
    got = main_of(outcomes, *flags, **options)
    verdict(name, got[0] == status and says in got[1] and got[2] == file, f"{got}, not {status}, {says!r}, {file!r}")


def changed(name, **parts):
    """Returns the outcomes in which one example has other complaints, skipped parts or hashes."""
    old = dict(zip(("complaints", "skipped", "hashes"), AS_RECORDED[name]))
    return {**AS_RECORDED, name: tuple({**old, **parts}.values())}


check("equal hashes are good", AS_RECORDED, status=0, says="2 passed, 0 failed\n")
OTHER = changed("Tone", hashes=["Tone --for 2s  ff"])
check("another hash is a failure", OTHER, status=1,
      says="FAIL Tone\n     the traces are not those of hashes.txt, but\n       Tone --for 2s  ff\n")
check("a run more is a failure", changed("Tone", hashes=["Tone --for 2s  03"] * 2), status=1, says="FAIL Tone\n")
check("a part that was skipped leaves the hashes out", changed("Tone", skipped=["no sound"], hashes=[]), status=0,
      says="2 passed, 0 failed, 1 skipped\n")
FAILED = changed("Tone", complaints=["no tone"], hashes=[])
check("a failure is printed alone", FAILED, status=1, says="FAIL Tone\n     no tone\n1 passed, 1 failed\n")
verdict("and without the list of hashes", "hashes.txt" not in main_of(FAILED)[1])
check("lines of an example that is gone are a failure", {"Ears": AS_RECORDED["Ears"]}, status=1,
      says="FAIL hashes.txt has lines of Tone, which no check is for")
check("but not with a word, for which only some examples run", AS_RECORDED, "Ears", status=0, recorded=RECORDED + "Gone 1  04\n",
      says="1 passed, 0 failed\n", file=RECORDED + "Gone 1  04\n")

NEW = RECORDED.replace("03", "ff")
check("hashes are recorded", OTHER, "--record-hashes", status=0, says="2 passed", file=NEW)
check("in place of those of examples that are gone", OTHER, "--record-hashes", status=0, says="2 passed",
      recorded=RECORDED + "Gone 1  04\n", file=NEW)
check("each run is recorded once, though a live example runs twice", OTHER, "--record-hashes", status=0,
      says="ok   Tone from other processes\n", live=["Tone"], file=NEW)
REFUSAL = "hashes.txt stays as it is, because not all examples were good\n"
check("nothing is recorded after a failure", FAILED, "--record-hashes", status=1, says=REFUSAL)
check("nothing is recorded where a part was skipped", changed("Tone", skipped=["no sound"], hashes=[]),
      "--record-hashes", status=1, says=REFUSAL)

sys.exit(finish())
