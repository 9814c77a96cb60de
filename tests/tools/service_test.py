#!/usr/bin/env python3
"""Checks tools/openr-host.service: systemd reads it, its exposure is that of the docs, and it allows
what a run does.

The system calls of a run are those that strace sees.  Without strace or systemd-analyze the checks
are skipped.  The last line is "N passed, N failed, N skipped".
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SERVICE = ROOT / "tools/openr-host.service"
THREATS = ROOT / "docs/threats.md"


def setting(name):
    """Returns the words of the setting `name`."""
    return re.search(rf"^{name}=(.*)$", SERVICE.read_text(), re.MULTILINE)[1].split()


def calls_of(group, seen):
    """Returns the system calls of a group such as @system-service, with those of groups in it."""
    if group in seen:
        return set()
    seen.add(group)
    listed = subprocess.run(["systemd-analyze", "syscall-filter", "--no-pager", group], text=True,
                            stdout=subprocess.PIPE, check=True).stdout.split("\n")
    found = set()
    for word in (line.strip() for line in listed[1:]):
        if word.startswith("@"):
            found |= calls_of(word, seen)
        elif word and not word.startswith("#"):
            found.add(word)
    return found


def allowed_calls():
    found = set()
    for word in setting("SystemCallFilter"):
        found |= calls_of(word, set()) if word.startswith("@") else {word}
    return found


def traced(openr, folder):
    """Runs what the service runs, for a moment; returns system calls and kinds of sockets."""
    words = [word.replace("${OPENR_ADDRESS}", "127.0.0.1").replace("%S/openr-host", str(folder))
             for word in setting("ExecStart")[1:] if word != "$OPENR_FLAGS"]
    trace = folder / "trace"
    subprocess.run(["strace", "-f", "-o", str(trace), str(openr), *words, "--rc-port", "0",
                    "--panel-port", "0", "--listen-rc-port", "0", "--monitor", "--for", "1s"],
                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   timeout=300, check=True)
    text = trace.read_text(errors="replace")
    return (set(re.findall(r"^\d+ +(\w+)\(", text, re.MULTILINE)),
            set(re.findall(r" socket\((AF_\w+)", text)))


def check(name, wrong):
    print(f"{'FAILED' if wrong else 'ok    '}  {name}" + "".join(f"\n    {line}" for line in wrong))
    return not wrong


def systemd_complaints(openr, folder):
    """Returns what systemd says about the service, with the built program in place of the installed one."""
    copy = folder / SERVICE.name
    text = SERVICE.read_text().replace("/usr/bin/openr", str(openr))
    copy.write_text("\n".join(line for line in text.split("\n") if not line.startswith("Documentation=")))
    said = subprocess.run(["systemd-analyze", "verify", "--man=no", str(copy)], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout
    return [line for line in said.splitlines() if SERVICE.name in line]


def exposure_complaints():
    """Returns how docs/threats.md differs from what systemd says about the exposure of the service.

    Versions of systemd know different settings, so the figure is that of the version in the text.
    """
    told, version = re.search(r"exposure ([\d.]+) \(OK; systemd (\d+)\)", THREATS.read_text()).groups()
    if not subprocess.run(["systemd-analyze", "--version"], text=True, stdout=subprocess.PIPE,
                          check=True).stdout.startswith(f"systemd {version} "):
        return []
    said = subprocess.run(["systemd-analyze", "security", "--offline=true", "--no-pager", str(SERVICE)], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout
    return [] if f"{SERVICE.name}: {told} OK" in said else [f"{told} in {THREATS.name}", *said.splitlines()[-1:]]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    openr = parser.parse_args().build.resolve() / "bin/openr"
    results, skipped = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        if not shutil.which("systemd-analyze") or not openr.exists():
            print(f"skipped: systemd-analyze or {openr} is not there")
            skipped = 4
        else:
            results.append(check("systemd reads the service", systemd_complaints(openr, folder)))
            results.append(check("the exposure is that of docs/threats.md", exposure_complaints()))
            if not shutil.which("strace"):
                print("skipped: strace is not there")
                skipped = 2
            else:
                calls, sockets = traced(openr, folder)
                results.append(check("the service allows the system calls of a run",
                                     sorted(calls - allowed_calls()) if len(calls) > 20 else
                                     ["the trace has hardly any system calls"]))
                results.append(check("the service allows the sockets of a run",
                                     sorted(sockets - set(setting("RestrictAddressFamilies")))))
    passed = sum(results)
    print(f"{passed} passed, {len(results) - passed} failed" + (f", {skipped} skipped" if skipped else ""))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
