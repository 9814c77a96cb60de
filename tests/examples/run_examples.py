#!/usr/bin/env python3
"""Builds every program of examples/ in a copy and runs it: does it print what its README says?

    run_examples.py --build DIR [WORD]
    run_examples.py --build DIR --record-hashes

DIR/bin/openr builds and runs; with WORD only examples whose name contains it.  Each
is run once more with every object in a process of its own, which has to be the same run.  Programs
that serve the network get a free port in their copy, and are asked by real clients on 127.0.0.1; a
recording of what was answered from other processes is replayed in one.
The trace of a run that nobody takes part in has the hash of hashes.txt.  --record-hashes writes this
file anew, for a commit that says why the runs are others now, unless an example failed or left a part
out.
The last line is "N passed, N failed" (", N skipped").
"""
import argparse
import os
import pathlib
import shutil
import sys
import tempfile
import traceback

from example import Example
import local_checks
import network_checks

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from job_pool import JobPool  # noqa: E402: the folder is put into the path first

EXAMPLES = ROOT / "examples"
HASHES = pathlib.Path(__file__).resolve().parent / "hashes.txt"


def checks():
    """Name of an example and its check, in the order of the names."""
    found = {}
    for module in (local_checks, network_checks):
        for name, function in vars(module).items():
            if name.startswith("check_"):
                found[name[len("check_"):]] = function
    return dict(sorted(found.items()))


def is_live(name):
    """Whether somebody outside takes part; such a run cannot be repeated, but replayed."""
    return name == "Hello" or hasattr(network_checks, f"check_{name}")


def recorded_hashes(name):
    """Returns the lines of hashes.txt about one example."""
    return [line for line in HASHES.read_text().splitlines() if line.startswith(name + " ")]


def names_gone(found):
    """Returns the names in hashes.txt of which `found`, the examples with a check, has none."""
    lines = [line for line in HASHES.read_text().splitlines() if line and not line.startswith("#")]
    return sorted({line.split()[0] for line in lines} - set(found))


def run(openr, name, check, scratch, apart):
    """Returns lines that say what is wrong (none if all is good), the skipped parts, and the hashes."""
    try:
        folder = scratch / (name + ("-apart" if apart else ""))
        folder.mkdir()
        example = Example(openr, EXAMPLES / name, folder, apart)
        check(example)
        return example.complaints, example.skipped, example.hashes
    except Exception:  # a broken check must not hide the others
        return [traceback.format_exc()], [], []


def difference(name, hashes):
    """Returns in lines how the hashes differ from those of hashes.txt."""
    wanted = recorded_hashes(name)
    if hashes == wanted:
        return []
    return ["the traces are not those of hashes.txt, but", *("  " + line for line in hashes),
            "instead of", *("  " + line for line in wanted)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("word", nargs="?", default="")
    parser.add_argument("--record-hashes", action="store_true")
    arguments = parser.parse_args()
    if arguments.word and arguments.record_hashes:
        parser.error("--record-hashes needs all examples, without a WORD")
    openr = (arguments.build / "bin/openr").resolve()
    found = checks()
    good, bad, skips, all_hashes = 0, 0, 0, []

    # Other tests run the examples in controllers/ (tests/controllers, tests/kit) and in python/
    # (tests/python); ros2/ needs ROS 2.
    folders = sorted(path.name for path in EXAMPLES.iterdir()
                     if path.is_dir() and path.name not in ("controllers", "python", "ros2"))
    unchecked = [name for name in folders if name not in found]
    if unchecked and not arguments.word:
        print(f"FAIL no check for {', '.join(unchecked)}")
        bad += 1
    gone = [] if arguments.word or arguments.record_hashes else names_gone(found)
    if gone:
        print(f"FAIL hashes.txt has lines of {', '.join(gone)}, which no check is for; --record-hashes drops them")
        bad += 1

    scratch = pathlib.Path(os.environ.get("OPENR_TEST_SCRATCH") or tempfile.mkdtemp(prefix="openr-examples-"))
    try:
        with JobPool(os.cpu_count()) as pool:
            passes = [(name, False) for name in found]
            passes += [(name, True) for name in found if is_live(name)]
            todo = {(name, apart): pool.submit(run, openr, name, found[name], scratch, apart)
                    for name, apart in passes if arguments.word in name}
            for (name, apart), future in todo.items():
                complaints, skipped, hashes = future.result()
                if not apart:
                    all_hashes += hashes
                # An example with a skipped or failed part has not all hashes, so they are not compared.
                if not (arguments.record_hashes or apart or complaints or skipped):
                    complaints = difference(name, hashes)
                name += " from other processes" if apart else ""
                print(f"{'FAIL' if complaints else 'ok  '} {name}", flush=True)
                for line in complaints + [f"skipped: {what}" for what in skipped]:
                    print("     " + line.replace("\n", "\n     "))
                good += not complaints
                bad += bool(complaints)
                skips += len(skipped)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    is_refused = arguments.record_hashes and (bad or skips or good == 0)
    if is_refused:
        print("hashes.txt stays as it is, because not all examples were good")
    elif arguments.record_hashes:
        HASHES.write_text("# Arguments and hash of the trace of each run of the examples (run_examples.py).\n" +
                          "".join(line + "\n" for line in all_hashes))
    print(f"{good} passed, {bad} failed" + (f", {skips} skipped" if skips else ""))
    return 1 if bad or good == 0 or is_refused else 0


if __name__ == "__main__":
    sys.exit(main())
