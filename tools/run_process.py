"""A process of `openr run`, for scripts and tests that control it."""
import re
import signal
import subprocess
import threading


class RunProcess:
    """A process of `openr run` with the given flags; `said` has the lines of its standard error."""

    def __init__(self, openr, *flags):
        self.openr = str(openr)
        self.said = []
        self.changed = threading.Condition()
        self.is_silent = False  # whether the standard error has ended
        self.process = subprocess.Popen(
            [self.openr, "run", "--rc-port", "0", *flags], stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        for line in self.process.stderr:
            with self.changed:
                self.said.append(line)
                self.changed.notify_all()
        with self.changed:
            self.is_silent = True
            self.changed.notify_all()

    def _match(self, pattern):
        return next((found for found in (re.search(pattern, line) for line in self.said) if found), None)

    def wait_for(self, pattern, seconds):
        """Waits until the run has printed a line with `pattern`, and returns the match.

        Returns None if the run ends without such a line, or prints none in time.
        """
        with self.changed:
            self.changed.wait_for(lambda: self.is_silent or self._match(pattern), seconds)
            return self._match(pattern)

    def end(self, seconds):
        """Presses the pause button, and returns the exit status.  Kills a run that does not end."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        try:
            return self.process.wait(seconds)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()
