"""Finding: a remark of a run about a program."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, NamedTuple


class Finding(NamedTuple):
    """An error, a warning or a note about a program.

    `message` is the number of the message that an object handled when the finding was added; 0 if
    there was none.  `said` is the content of this message in words; "" if the content is not known.
    """

    severity: str
    object: str
    time_s: float
    text: str
    message: int = 0
    said: str = ""


def findings_of(found: Iterable[Mapping[str, Any]]) -> list[Finding]:
    """Returns the findings that the process of a run has sent."""
    return [Finding(each["severity"], each["object"], each["time_s"], each["text"], each["message"],
                    each["said"]) for each in found]
