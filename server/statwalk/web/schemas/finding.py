"""The bodies about the verifier's findings."""

from __future__ import annotations

from statwalk.machine.lint.findings import Severity
from statwalk.web.schemas.base import ResponseModel


class FindingView(ResponseModel):
    """A fault of a machine, or a property that is proved or refuted; `line` 0: it has no line in the file."""

    kind: str
    severity: Severity
    message: str
    line: int
    state: str | None
    event: str | None
    layer: str
    """the layer whose table the finding is about; empty: the base, or the whole machine"""
    replay: tuple[tuple[int, str], ...]
    """the counterexample of a refuted property: the inputs as (tick, event), for a new stage at 60 Hz"""


class FindingsView(ResponseModel):
    """All findings of the verifier about one machine."""

    findings: list[FindingView]
