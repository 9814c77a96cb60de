#!/usr/bin/env python3
"""tools/power_cuts.py: what it finds in traces that are written here, and in runs that only pretend.  The last
line is "N passed, N failed"."""
import signal
import sys
import types
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/support"), str(ROOT / "tools")]
import power_cuts  # noqa: E402
import remote_run as rc  # noqa: E402
from verdicts import finish, verdict  # noqa: E402

MOTIONS, IMAGES = "/s/OPEN-R/MW/DATA/P", "/s/OPEN-R/MW/OBJS"


def renamed(folder, source, target):
    """Returns the lines of a trace in which a file is written through and renamed, and its folder written."""
    return [f"7 fsync(5<{folder}/{source}>) = 0", f'7 rename("{folder}/{source}", "{folder}/{target}") = 0',
            f"7 fsync(5<{folder}>) = 0"]


def answered(command):
    """Returns the line of a trace in which the robot answers a command."""
    packet = rc.ANSWER.pack(b"RC", rc.ANSWER.size, 2, command, 0, 0, 0, 0)
    return f'''7 sendto(9<TCP:[1]>, "{"".join(f"{chr(92)}x{byte:02x}" for byte in packet)}", 16, 0, NULL, 0) = 16'''


TRACE = [*renamed(MOTIONS, "UPLOAD0.TMP", "KILLED.MTN"), answered(rc.UPLOAD_END),
         *renamed(IMAGES, "UPLOAD0.OLD", "CONTROLL.OLD"), *renamed(IMAGES, "UPLOAD0.TMP", "CONTROLL.BIN"),
         answered(rc.UPLOAD_END), f'7 unlink("{MOTIONS}/KILLED.MTN")    = 0', f"7 fsync(5<{MOTIONS}>) = 0",
         answered(rc.DELETE)]


def check_order(name, lines, wanted):
    """Checks that what is found wrong in a trace is one text with `wanted` in it, or nothing if that is ""."""
    wrong = power_cuts.wrong_order(lines)
    is_right = len(wrong) == 1 and wanted in wrong[0] if wanted else wrong == []
    verdict(name, is_right, "\n".join(wrong) or "nothing is found")


def without(i):
    return TRACE[:i] + TRACE[i + 1:]


check_order("a trace in order is good", TRACE, "")
check_order("a file must be written through before its rename", without(0), "was not written through")
check_order("a folder must be written through after a rename", without(6), f"rename to {IMAGES}/CONTROLL.OLD")
check_order("a folder must be written through after a removal", without(-2),
            f"after the removal of {MOTIONS}/KILLED.MTN")
check_order("the folder is written through before the answer", [*TRACE[:-3], TRACE[-1], *TRACE[-3:-1]],
            "DELETE is answered before")
check_order("a trace needs its deletion", TRACE[:-3], "0 removals of the motion and 0 answers")


class Pretended:
    """Uploads to a run that does what `case` says: see ask()."""

    def __init__(self, case, folder):
        self.case = case
        self.trace = Path(folder, "trace")
        self.trace.write_text("7 close(5) = 0\n")
        said = types.SimpleNamespace(read_text=lambda: "words of the run")
        self.run = types.SimpleNamespace(process=types.SimpleNamespace(returncode=case.get("status", 0)), said=said)

    def upload(self):
        return self.case.get("whole", True)

    def has_ended(self, limit_s):
        verdict(f"a run gets {power_cuts.LIMIT_S} s to end", limit_s == power_cuts.LIMIT_S, str(limit_s))
        if self.case.get("asked", True):  # only now, as when the signal comes at the last call
            self.trace.write_text("7 close(5) = 0\n7 --- SIGTERM {si_signo=SIGTERM} ---\n")
        return self.case.get("ended", True)

    def end(self):
        pass

    def left(self):
        return self.case.get("left", [])

    def wrong(self, may_lack):
        return []

    def start_again(self):
        return []


def ask(**case):
    """Returns what ask_to_end() says of a run which, if `case` is empty, gets the signal and ends well."""
    power_cuts.Uploads = lambda openr, folder, *strace: Pretended(case, folder)
    return power_cuts.ask_to_end("openr", "close", 1)


def check_end(name, got, wanted):
    verdict(name, got == wanted, f"{got}, not {wanted}")


check_end("a run that is asked at its last call ends", ask(), [])
check_end("a run that ends before it takes signals", ask(whole=False, status=-signal.SIGTERM),
          [f"status {-signal.SIGTERM}: words of the run"])
check_end("a run that is never asked makes fewer calls", ask(asked=False, ended=False), None)
check_end("a run that ends although it is not asked", ask(asked=False), ["the run has ended without SIGTERM"])
check_end("a run that goes on", ask(ended=False),
          [f"the run goes on {power_cuts.LIMIT_S} s after SIGTERM: words of the run"])
check_end("uploads that fail in a run that goes on", ask(whole=False, asked=False, ended=False),
          ["the uploads failed, and the run goes on: words of the run"])
check_end("a file that is left", ask(left=["UPLOAD0.TMP"]), ["['UPLOAD0.TMP'] is left behind"])

sys.exit(finish())
