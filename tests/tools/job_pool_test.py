#!/usr/bin/env python3
"""tools/job_pool.py: Ctrl-C ends a script when its running jobs have ended.  The last line is "N passed, N failed"."""
import re
import signal
import sys
import threading
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
from job_pool import JobPool  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

# A shell that has begun this test with '&' lets it ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)
PATIENCE_S = 20
jobs, is_running = [], threading.Event()


def first():
    """Runs until the other job is cancelled."""
    is_running.set()
    end = time.monotonic() + PATIENCE_S
    while not (len(jobs) == 2 and jobs[1].cancelled()) and time.monotonic() < end:
        time.sleep(0.01)
    return "done"


try:
    with JobPool(1) as pool:
        jobs.append(pool.submit(first))
        jobs.append(pool.submit(lambda: "done"))
        is_running.wait()
        signal.raise_signal(signal.SIGINT)
    verdict("Ctrl-C ends the block", False)
except KeyboardInterrupt:
    verdict("Ctrl-C ends the block", True)
verdict("the job that runs has ended", jobs[0].result() == "done")
verdict("the job that waits does not begin", jobs[1].cancelled())

with JobPool(1) as pool:
    jobs = [pool.submit(lambda: "done") for _ in range(3)]
verdict("without an exception, all jobs run", [job.result() for job in jobs] == ["done"] * 3)

# The results of pool.map() cancel the jobs that wait by themselves.
scripts = [path for folder in ("tools", "tests/docs", "tests/examples", "tests/fuzz", "tests/threads")
           for path in (ROOT / folder).glob("*.py")]
others = [path.name for path in scripts
          if re.search(r"ThreadPoolExecutor\(.*\) as (\w+):(.|\n)*\1\.submit\(", path.read_text())]
verdict("scripts that submit jobs use the pool", not others, str(others))

sys.exit(finish())
