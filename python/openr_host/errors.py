"""Exceptions of openr_host."""
from __future__ import annotations

from typing import Any, Optional, Sequence

from .finding import Finding


class Error(Exception):
    """The base class of all exceptions of this module."""


class ProcessError(Error):
    """The process of a run cannot be started, has ended, or answers nonsense."""


class Refused(Error):
    """The run has refused a wrong command, which has changed nothing."""


class BuildFailed(Error):
    """Objects could not be built.  The text is what `openr build` has printed: the compiler's lines
    first, then the list of what is missing."""


class NotMet(Error):
    """The condition or message for which a call has waited did not come in time."""


class RunEnded(Error):
    """The run is over: the robot is off, or an object has crashed.

    `by` is a word of docs/cli.md, "How a run ends": pause, battery, power-off, fatal, strict,
    crash, handler-limit, no-boot; `why` is a sentence about that end.  `findings`, `console`
    and `report` are the results of the methods of Run with these names at the end of the run.  After a
    crash, or a handler that does not return, the run is closed, so only these results are left;
    `report` is empty if the process could not answer any more.
    """

    def __init__(self, by: str, why: str, text: str = "", findings: Sequence[Finding] = (),
                 console: Sequence[str] = (), report: Optional[dict[str, Any]] = None) -> None:
        super().__init__(f"ended by {by}: {why}" + (f"\n{text}" if text else ""))
        self.by = by
        self.why = why
        self._text = text
        self.findings: list[Finding] = list(findings)
        self.console: list[str] = list(console)
        self.report: dict[str, Any] = report or {}

    def __reduce__(self) -> tuple[Any, ...]:
        # Lets multiprocessing send the exception from a worker to the process that waits for its result.
        return type(self), (self.by, self.why, self._text, self.findings, self.console, self.report)
