#!/usr/bin/env python3
"""tools/layers.py: the includes that it refuses, and those that it allows.  The last line is "N passed, N failed"."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
sys.path.insert(0, str(ROOT / "tools"))
from layers import SDK_HEADERS, TYPES_ONLY  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

# Name of a file, its first line, and what the tool says about this line; "" if the line is allowed.
FILES = [
    ("runtime/core/a.cc", '#include "runtime/core/a.h"', ""),
    ("runtime/core/a.cc", '#include "runtime/base/a.h"', ""),
    ("runtime/base/a.cc", '#include "runtime/core/a.h"', "runtime/base may not include runtime/core/a.h"),
    ("runtime/core/a.h", '#include "virtualrobot/a.h"', "runtime/core may not include virtualrobot/a.h"),
    ("virtualrobot/a.h", '#include "runtime/core/a.h"', ""),
    ("virtualrobot/base/a.h", '#include "virtualrobot/a.h"', "virtualrobot/base may not include virtualrobot/a.h"),
    ("runtime/core/a.cc", '#include "runtime/new/a.h"', "runtime/core may not include runtime/new/a.h"),
    ("kit/a.h", "#include <openr/testing.h>", ""),
    # Headers of the SDK count as headers of the folder that defines their functions.
    ("runtime/core/a.h", "#include <OPENR/OSubject.h>", ""),
    ("runtime/core/a.h", "#include <OPENR/OStatus.h>", ""),
    ("runtime/ipstack/a.cc", "#include <IPAddress.h>", ""),
    ("runtime/hooks/a.cc", "#include <antEnvMsg.h>", ""),
    ("virtualrobot/a.cc", "#include <OPENR/OPENRAPI.h>", ""),
    ("runtime/core/robot_calls.h", "#include <OPENR/OPENRAPI.h>", ""),
    ("runtime/core/a.h", "#include <OPENR/OPENRAPI.h>",
     "runtime/core may not include OPENR/OPENRAPI.h, whose functions are in runtime/api"),
    ("runtime/core/a.cc", '#include "MCOOP.h"',
     "runtime/core may not include MCOOP.h, whose functions are in runtime/api"),
    ("runtime/config/a.cc", "#include <IPAddress.h>",
     "runtime/config may not include IPAddress.h, whose functions are in runtime/api"),
    ("runtime/api/a.cc", "#include <antEnvMsg.h>",
     "runtime/api may not include antEnvMsg.h, whose functions are in runtime/ipstack"),
    # The library openr/remote includes its own headers only.
    ("openr/remote/a.cc", '#include "openr/remote/a.h"', ""),
    ("openr/remote/a.cc", "#include <vector>", ""),
    ("openr/remote/a.cc", '#include "openr/motion/a.h"', "openr/remote may not include openr/motion/a.h"),
    ("openr/remote/a.cc", "#include <OPENR/OStatus.h>", "openr/remote may not include headers of the SDK"),
    ("openr/remote/a.cc", "#include <IPAddress.h>",
     "openr/remote may not include IPAddress.h, whose functions are in runtime/api"),
]


def said_about(name, line):
    """Returns what the tool prints about a checkout that has one file with this line."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, name)
        file.parent.mkdir(parents=True)
        file.write_text(line + "\n")
        done = subprocess.run([sys.executable, ROOT / "tools/layers.py", folder], capture_output=True, text=True,
                              check=False)
    if done.stderr or done.returncode != bool(done.stdout):
        return f"status {done.returncode}: {done.stdout}{done.stderr}"
    return done.stdout.strip()


for name, line, wanted in FILES:
    said = said_about(name, line)
    verdict(f"{name}: {line}", said == (wanted and f"{name}:1: {wanted}"), said)
said = said_about("runtime/new/a.cc", "int a;")
verdict("a new folder", said == "runtime/new/a.cc: its folder is not in LAYERS of tools/layers.py", said)
for header in " ".join(SDK_HEADERS.values()).split():
    verdict(f"{header} is a header of the SDK", (ROOT / "runtime/include" / header).is_file())
for name, header in TYPES_ONLY:
    verdict(f"{name} includes {header}", f"#include <{header}>\n" in (ROOT / name).read_text())
sys.exit(finish())
