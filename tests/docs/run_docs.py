#!/usr/bin/env python3
"""Runs every command and listing of docs/cookbook and docs/guide: does it do what the page says?

    run_docs.py --build DIR [--slow] [-j N] [PAGE...]

DIR/bin/openr is the program of the pages.  Without PAGE, all pages run, those whose name contains PAGE
otherwise; PAGE may also be a file.  --slow runs the blocks marked `slow` as well.  page.py says what
the blocks of a page are.  A page runs in an empty folder and a network of its own where the system
allows that; where it does not, pages run one after the other.  --keep FOLDER leaves their files there.
The last line is "N passed, N failed".
"""
import argparse
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from page import Fault, missing_line, read_blocks

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from job_pool import JobPool  # noqa: E402: the folder is put into the path first

FOLDERS = ("docs/cookbook", "docs/guide")
LIMIT_S = 900  # for one page, against commands that never end
OUTPUT_LINES_MAX = 60
NETWORK = [sys.executable, str(pathlib.Path(__file__).with_name("own_network.py"))]


def environment(build, home):
    """Returns the environment of a person who followed docs/cookbook/README.md: openr in PATH, $OPENR_HOST."""
    kept = ("ASAN_OPTIONS", "UBSAN_OPTIONS", "CCACHE_DIR", "CCACHE_SLOPPINESS", "OPENR_HOST_CXX", "OPENR_HOST_CC")
    env = {key: os.environ[key] for key in kept if key in os.environ}
    env.update(PATH=f"{build / 'bin'}:{os.environ['PATH']}", HOME=str(home), LANG="C.UTF-8", TERM="dumb",
               NO_COLOR="1", OPENR_HOST=str(ROOT), PYTHONPATH=str(ROOT / "python"), PYTHONDONTWRITEBYTECODE="1")
    return env


def quoted_wrongly(block):
    """Returns what is wrong with a listing that is to stand in a file of the checkout, or None."""
    source = ROOT / block.name
    if not source.is_file():
        return f"there is no {block.name}"
    line = missing_line(block.text, source.read_text())
    return None if line is None else f"{block.name} has no such line here: {line}"


def script(blocks, scratch, state, slow):
    """Returns the bash script of a page, which notes the line of each block before it begins.

    `state` is a folder for the block that runs, for listings and for the output of each block.
    """
    lines = ["set -e -u -o pipefail"]
    for block in blocks:
        if block.kind == "file":
            (state / f"{block.line}.listing").write_text(block.text)
            target = scratch / block.name
            lines += [f"mkdir -p '{target.parent}'", f"cp '{state}/{block.line}.listing' '{target}'"]
        elif block.kind == "sh" and (slow or not block.slow):
            lines += [f"echo {block.line} >'{state}/now'", f"exec >'{state}/{block.line}.output' 2>&1"]
            if block.status == 0:
                lines.append(block.text)
            else:
                lines += ["set +e", "(", "set -e", block.text, ")",
                          f"__status=$?; set -e; [ $__status -eq {block.status} ] || "
                          f"{{ echo \"status $__status, the page says {block.status}\"; false; }}"]
    return "\n".join(lines + [f"echo done >'{state}/now'", ""])


def reported(page, block, what, output):
    lines = output.rstrip().splitlines()
    if len(lines) > OUTPUT_LINES_MAX:
        lines = ["[...]"] + lines[-OUTPUT_LINES_MAX:]
    text = [f"{page}:{block.line}: {what}"]
    text += [f"    $ {line}" for line in block.text.rstrip().splitlines()]
    return "\n".join(text + [f"    | {line}" for line in lines])


def execute(file, environ, scratch, private_network):
    """Runs the script; returns its exit status, or None when it did not end in time."""
    command = (NETWORK if private_network else []) + ["bash", str(file)]
    process = subprocess.Popen(command, cwd=scratch, env=environ, start_new_session=True,
                               stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        complaint = process.communicate(timeout=LIMIT_S)[1]
        return process.returncode, complaint.decode(errors="replace")
    except subprocess.TimeoutExpired:
        return None, ""
    finally:  # the page may have left programs in the background
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        process.wait()


def read(file):
    return file.read_text(errors="replace") if file.exists() else ""


def complaints(page, name, build, folder, slow, private_network):
    """Returns what is wrong with a page; `folder` is for its files."""
    try:
        blocks = read_blocks(page.read_text())
    except Fault as fault:
        return [f"{name}:{fault.line}: {fault}"]
    wrong = [f"{name}:{block.line}: {fault}" for block in blocks if block.kind == "from"
             for fault in [quoted_wrongly(block)] if fault]
    scratch, state, home = folder / "page", folder / "state", folder / "home"
    for path in (scratch, state, home):
        path.mkdir(parents=True)
    (state / "page.sh").write_text(script(blocks, scratch, state, slow))
    status, said = execute(state / "page.sh", environment(build, home), scratch, private_network)
    now = read(state / "now").strip()
    ran = [block for block in blocks if block.kind == "sh" and (slow or not block.slow)]
    if now != "done":
        if not now:
            return wrong + [f"{name}: could not begin: {said}"]
        block = next(block for block in ran if block.line == int(now))
        what = f"not done after {LIMIT_S} s" if status is None else f"ended with status {status}"
        wrong.append(reported(name, block, what, read(state / f"{now}.output") + said))
        ran = ran[:ran.index(block)]
    for block, after in zip(blocks, blocks[1:]):
        if after.kind == "output" and block in ran:
            output = read(state / f"{block.line}.output")
            line = missing_line(after.text, output)
            if line is not None:
                wrong.append(reported(name, block, f"line {after.line} says that this prints '{line}'", output))
    return wrong


def chosen(words):
    """Returns (file, name) of the pages to run."""
    every = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.md"))]
    if not words:
        return [(path, str(path.relative_to(ROOT))) for path in every]
    found = []
    for word in words:
        if pathlib.Path(word).is_file():
            found.append((pathlib.Path(word).resolve(), word))
        else:
            hits = [(path, str(path.relative_to(ROOT))) for path in every if word in str(path)]
            if not hits:
                sys.exit(f"no page is named '{word}'")
            found += hits
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--slow", action="store_true")
    parser.add_argument("-j", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("page", nargs="*")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    if not (build / "bin/openr").exists():
        sys.exit(f"{build}/bin/openr is not built")
    scratch = pathlib.Path(os.environ.get("OPENR_TEST_SCRATCH") or tempfile.mkdtemp(prefix="openr-docs-"))
    private_network = subprocess.run(NETWORK + ["true"], stderr=subprocess.DEVNULL).returncode == 0
    counts = {True: 0, False: 0}

    def run(page, name):
        begin = time.monotonic()
        folder = scratch / name.replace("/", "_")
        found = complaints(page, name, build, folder, arguments.slow, private_network)
        return found, time.monotonic() - begin

    try:
        with JobPool(arguments.j if private_network else 1) as pool:
            todo = [(name, pool.submit(run, page, name)) for page, name in chosen(arguments.page)]
            for name, future in todo:
                found, seconds = future.result()
                print(f"{'FAIL' if found else 'ok  '} {name} ({seconds:.1f} s)", flush=True)
                for text in found:
                    print(text)
                counts[not found] += 1
        if arguments.keep:
            shutil.copytree(scratch, arguments.keep, symlinks=True, dirs_exist_ok=True)
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
    used = os.times()
    print(f"{used.children_user + used.children_system:.0f} s of processor time")
    print(f"{counts[True]} passed, {counts[False]} failed")
    return 1 if counts[False] or not counts[True] else 0


if __name__ == "__main__":
    sys.exit(main())
