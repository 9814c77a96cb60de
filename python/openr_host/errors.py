"""Exceptions of openr_host."""
from __future__ import annotations


class Error(Exception):
    """What all exceptions of this module are derived from."""


class ProcessError(Error):
    """The process of a run cannot be started, has ended, or answers nonsense."""


class Refused(Error):
    """A command was wrong, and has changed nothing."""


class BuildFailed(Error):
    """Objects could not be built.  The text is what `openr build` has said: the compiler's lines
    first, then what is missing."""


class NotMet(Error):
    """What a call has waited for did not come in time."""


class RunEnded(Error):
    """The run is over: the robot is off, or an object has crashed.

    `by` is a word of docs/cli.md, "How a run ends": pause, battery, power-off, fatal, strict,
    crash, handler-limit, no-boot; `why` is the sentence about it.
    """

    def __init__(self, by: str, why: str, text: str = "") -> None:
        super().__init__(f"ended by {by}: {why}" + (f"\n{text}" if text else ""))
        self.by = by
        self.why = why
