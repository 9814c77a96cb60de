"""Builds folders of objects, as the command `openr build` does."""
from __future__ import annotations

import os
import pathlib
import re
import shlex
import subprocess
import sys
from typing import Optional, Union

from ._channel import find_program
from .errors import BuildFailed, Error, Refused

VARIANTS = ("debug", "sanitize", "coverage")
# The line at the end of a good build: the command that runs the stick.
_STICK = re.compile(r" run --stick (.+)$", re.MULTILINE)


def build(folder: Union[str, "os.PathLike[str]"], variant: str = "", *,
          output: Union[str, "os.PathLike[str]"] = "", jobs: int = 0, echo: bool = False,
          program: Optional[str] = None) -> pathlib.Path:
    """Builds a folder of objects with `openr build`, and returns the stick, for `Run`.

    `variant` is "debug", "sanitize" or "coverage"; "" means a build without special flags.  The stick
    is made in the folder, or at the path `output` if that is given.  `jobs` compilers run at once; 0
    means one compiler for each processor.  With `echo`, all messages of the compilers are printed on
    standard error, warnings too.  Raises BuildFailed with the compiler's lines if an image of the stick
    is missing.
    """
    if variant and variant not in VARIANTS:
        raise Refused(f"there is no variant '{variant}'; there are {', '.join(VARIANTS)}")
    command = [find_program(program), "build", os.path.abspath(folder)]
    command += [f"--{variant}"] if variant else []
    command += ["--output", os.path.abspath(output)] if output else []
    command += ["--jobs", str(jobs)] if jobs else []
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, errors="replace")
    if echo:
        sys.stderr.write(done.stderr)
    if done.returncode != 0:
        raise BuildFailed(done.stderr.strip() or f"openr build has ended with status {done.returncode}")
    return _only_stick(os.fspath(folder), done.stdout)


def _only_stick(folder: str, said: str) -> pathlib.Path:
    """Returns the stick that `said`, the output of a good build, names."""
    sticks = [shlex.split(match[1])[0] for match in _STICK.finditer(said)]
    if len(sticks) != 1:
        raise Error(f"{folder}: {len(sticks)} sticks have been built: {', '.join(sticks)}; "
                    "give one of them to Run, or build a folder with one stick")
    return pathlib.Path(sticks[0])
