#!/usr/bin/env python3
"""The commands of docs/cookbook/05-remote-processing.md for two computers, on two of them.

    two_hosts_test.py --build BUILD

The computers are two network namespaces with a cable between them, host names and copies of the stick
of their own.  Where the system does not allow such namespaces, the test is skipped.
The last line is "N passed, N failed", or with ", N skipped".
"""
import argparse
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
sys.path.insert(0, str(ROOT / "tests/docs"))
from page import read_blocks  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

PAGE = ROOT / "docs/cookbook/05-remote-processing.md"
INSIDE = "OPENR_TEST_TWO_HOSTS"  # set in the process that has a network of its own
LIMIT_S = 120


def commands_of_page(blocks):
    """Returns the words of the commands openr run and openr join that name an address."""
    lines = [line for block in blocks if block.kind != "file" for line in block.text.splitlines()]
    return {words[1]: words for words in map(shlex.split, lines) if "--dds-address" in words}


def option(words, name):
    return words[words.index(name) + 1]


def ip(*words, at=()):
    subprocess.run([*at, "ip", *words], check=True)


class OtherHost:
    """A network namespace with a host name, at the other end of a cable to this one."""

    def __init__(self, own_address, address):
        self._holder = subprocess.Popen(["unshare", "--net", "--uts", "sh", "-c", "echo && exec sleep 600"],
                                        stdout=subprocess.PIPE)
        self._holder.stdout.readline()  # printed in the new namespaces
        self.enter = ["nsenter", "--net", "--uts", "--target", str(self._holder.pid)]
        subprocess.run([*self.enter, "hostname", "second"], check=True)
        ip("link", "set", "lo", "up")
        ip("link", "add", "cable", "type", "veth", "peer", "name", "cable", "netns", str(self._holder.pid))
        for at, name in (((), own_address), (self.enter, address)):
            ip("address", "add", f"{name}/24", "dev", "cable", at=at)
            ip("link", "set", "cable", "up", at=at)
        ip("link", "set", "lo", "up", at=self.enter)

    def close(self):
        self._holder.kill()
        self._holder.wait()


def state(text):
    found = re.search(r"state ([0-9a-f]{16})", text)
    return found[1] if found else None


def test(openr, folder):
    blocks = read_blocks(PAGE.read_text())
    page = commands_of_page(blocks)
    verdict("the page has a command for each computer", sorted(page) == ["join", "run"], str(page))
    run, join = page["run"], page["join"]
    shutil.copytree(ROOT / "examples/TalkListen", folder / "first/TalkListen")
    subprocess.run([openr, "build", folder / "first/TalkListen"], check=True, capture_output=True)
    shutil.copytree(folder / "first/TalkListen/MS", folder / "second/TalkListen/MS")
    more = ["--for", "1s", "--rate", "max", "--no-panel", "--rc-port", "0"]
    alone = subprocess.run([openr, "run", "--stick", option(run, "--stick"), *more], cwd=folder / "first",
                           capture_output=True, text=True, timeout=LIMIT_S)
    placement = option(run, "--placement")
    (folder / "first" / placement).write_text(next(b.text for b in blocks if b.name == placement))
    other = OtherHost(option(run, "--dds-address"), option(join, "--dds-address"))
    joined = subprocess.Popen([*other.enter, openr, *join[1:]], cwd=folder / "second",
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        done = subprocess.run([openr, *run[1:], *more], cwd=folder / "first", capture_output=True, text=True,
                              timeout=LIMIT_S)
        if done.returncode != 0:
            joined.kill()  # nobody would end it
        said = joined.communicate(timeout=LIMIT_S)[0]
    finally:
        joined.kill()
        other.close()
    verdict("the run ends well", done.returncode == 0, done.stdout + done.stderr + said)
    verdict("the joined process ends well", joined.returncode == 0, said)
    verdict("its object ran there", "has joined run 'talk'" in said and "with listener" in said, said)
    verdict("the state is that of a run in one process",
            state(alone.stderr) is not None and state(alone.stderr) == state(done.stderr),
            alone.stderr + done.stderr)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=Path, required=True)
    arguments = parser.parse_args()
    if INSIDE not in os.environ:
        namespaces = ["unshare", "--user", "--map-root-user", "--net", "--uts"]
        cable = ["ip", "link", "add", "one", "type", "veth", "peer", "name", "other"]
        if shutil.which("ip") is None or subprocess.run([*namespaces, *cable], capture_output=True).returncode != 0:
            print("this system has no network namespaces for the test, or no ip")
            print("0 passed, 0 failed, 1 skipped")
            return 0
        os.environ[INSIDE] = "yes"
        os.execvp(namespaces[0], [*namespaces, sys.executable, __file__, "--build", str(arguments.build.resolve())])
    with tempfile.TemporaryDirectory() as folder:
        test(arguments.build / "bin/openr", Path(folder))
    return finish()


if __name__ == "__main__":
    sys.exit(main())
