"""The findings about a table."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

Severity = Literal["error", "warning", "info"]

SUBJECT_ENDS = {"property": ": ", "undefined state": " is no state", "unused motion": ": "}
"""the text that ends the subject of a message, for kinds whose message has more than the subject"""
LINE = re.compile(r" \(line [0-9]+\)")


@dataclass(frozen=True)
class Finding:
    """A fault of a machine, or the result of a property; `line` 0 if it is about no line."""

    kind: str
    severity: Severity
    message: str
    line: int = 0
    state: str | None = None
    event: str | None = None
    layer: str = ""
    """the layer whose table it is about; empty: the base, or the machine as a whole"""
    replay: tuple[tuple[int, str], ...] = ()
    """for a refuted property: the (tick, event) inputs of the counterexample, from a fresh stage at 60 Hz"""
    ticks: int = 0
    """after so many ticks of its replay a stage has shown it"""

    @property
    def subject(self) -> str:
        """Returns the part of the message that stays if lines are added above it, or if fewer cells have a
        wrong name.
        """
        return LINE.sub("", self.message).partition(SUBJECT_ENDS.get(self.kind, "\n"))[0]

    @property
    def about(self) -> tuple[str, str, str]:
        """Returns kind, layer and subject: equal if two versions of a machine have the same fault."""
        return self.kind, self.layer, self.subject
