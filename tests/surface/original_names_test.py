#!/usr/bin/env python3
"""Every name of tools/surface/original_names.tsv comes with its header, with nothing else included, and
has the robot's size, offsets, value and signature; gnu++98 to gnu++14, g++ and clang++, 64 bit and,
where that compiler is installed, 32 bit.  The last line is "N passed, N failed"."""
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools/surface"))
import original_names  # noqa: E402
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "support"))
from verdicts import finish, verdict  # noqa: E402

# Each header alone with these; a source with all of them with the others.
ALONE = [("g++", "98"), ("clang++", "14"), ("mipsel-linux-gnu-g++", "98")]
TOGETHER = [("g++", "11"), ("g++", "14"), ("clang++", "98"), ("clang++", "11")]
WARNINGS = ["-Wall", "-Wextra", "-Werror", "-Wno-invalid-offsetof"]

def compiles(compiler, level, text):
    """(whether it does, what the compiler says)"""
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "names.cc"
        source.write_text(text)
        done = subprocess.run([compiler, f"-std=gnu++{level}", *WARNINGS, "-fsyntax-only",
                               f"-I{ROOT / 'runtime/include'}", str(source)], capture_output=True, text=True)
    errors = re.findall(r"^.*error.*$", done.stderr, re.M)[:6]
    return done.returncode == 0, "\n".join(errors)


def all_jobs(rows):
    by_header = original_names.sources(rows)
    together = "".join(f"#include <{header}>\n" for header in by_header if header != "OPENR/stub_macro.h")
    for compiler, level in ALONE:
        for header, text in by_header.items():
            yield f"<{header}> alone", compiler, level, text
    for compiler, level in TOGETHER:
        yield "all headers", compiler, level, original_names.source_of("MCOOP.h", rows).replace(
            "#include <MCOOP.h>\n", together)


def spoiled(rows):
    """A row of each kind with one fact that is wrong, which must not compile."""
    wrong = {"structSystemTime": ("useconds @4", "useconds @0"), "EtherDeviceInfo": ("8 bytes", "12 bytes"),
             "OSpeakerVolume": ("4 bytes", "2 bytes"), "ospksndMONO16K8B": ("2", "3"),
             "ORawJointCommandValue": ("p @2 byte", "p @2 word"), "OFbkImage::GetTagInfo": ("()", "(int)"),
             "EtherMACAddress::ToByte": ("(byte*)", "(int)")}
    for row in rows:
        if row.name in wrong:
            old, new = wrong[row.name]
            assert old in row.facts, row
            yield row._replace(facts=row.facts.replace(old, new))
    yield original_names.Row("brings", "OTime", "OPENR/OStatus.h", "OTime use; (void)use;", "")


def main():
    rows = list(original_names.rows())
    names = {row[1] for row in original_names.table("original_names.tsv")}
    for name, reason in original_names.left_out().items():
        verdict(f"{name} is left out for a reason", name in names and len(reason) > 20)
    have = {compiler: shutil.which(compiler) for compiler, _ in ALONE}
    for compiler, path in have.items():
        if not path:
            print(f"not checked: {compiler} is not installed")
    jobs = [(name, compiler, level, text) for name, compiler, level, text in all_jobs(rows) if have[compiler]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = pool.map(lambda job: compiles(*job[1:]), jobs)
        for (name, compiler, level, _), (good, said) in zip(jobs, results):
            verdict(f"{name}: {compiler} gnu++{level}", good, said)
        bad = list(spoiled(rows))
        results = pool.map(lambda row: compiles("g++", "98", original_names.source_of(row.header, [row])), bad)
        for row, (good, _) in zip(bad, results):
            verdict(f"a wrong {row.kind} is noticed: {row.name}", not good)
    return finish()


if __name__ == "__main__":
    sys.exit(main())
