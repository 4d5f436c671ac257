"""What may be found in a table, and how it is said."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Severity = Literal["error", "warning", "info"]


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
