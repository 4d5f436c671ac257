"""What may be found in a table, and how it is said."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

Severity = Literal["error", "warning", "info"]

SUBJECT_ENDS = {"property": ": ", "undefined state": " is no state"}
"""how the part of a message that says what it is about ends, where it is not all of it"""
LINE = re.compile(r" \(line [0-9]+\)")


@dataclass(frozen=True)
class Finding:
    """One thing that is wrong with a machine, or was proved of it; `line` 0 where there is none to name."""

    kind: str
    severity: Severity
    message: str
    line: int = 0
    state: str | None = None
    event: str | None = None
    layer: str = ""
    """the layer whose table it is about; empty: the base, or the machine as a whole"""
    replay: tuple[tuple[int, str], ...] = ()
    """of a property that is refuted: (tick, event) of what comes from outside in the counterexample, from a fresh stage at 60 Hz"""

    @property
    def about(self) -> tuple[str, str, str]:
        """What stays the same where lines are added above it, or a wrong name stands in fewer cells: kind, layer and subject."""
        return self.kind, self.layer, LINE.sub("", self.message).partition(SUBJECT_ENDS.get(self.kind, "\n"))[0]
