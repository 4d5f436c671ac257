"""The bodies about the verifier's findings."""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.machine.lint.findings import Finding, Severity
from statwalk.web.schemas.base import ResponseModel


class FindingView(ResponseModel):
    """A fault of a machine, or a property that is proved or refuted; `line` 0: it has no line in the file."""

    kind: str
    severity: Severity
    message: str
    subject: str
    """the part of the message that stays while other lines and cells change: two versions of a machine have
    the same fault if kind, layer and subject are equal
    """
    line: int
    state: str | None
    event: str | None
    layer: str
    """the layer whose table the finding is about; empty: the base, or the whole machine"""
    replay: tuple[tuple[int, str], ...]
    """the counterexample of a refuted property: the inputs as (tick, event), for a new stage at 60 Hz"""
    ticks: int
    """after so many ticks of its replay a stage has shown it"""


MOST_FINDINGS = 200
"""in one answer"""


def finding_views(findings: Sequence[Finding]) -> list[FindingView]:
    """Returns the first findings, at most `MOST_FINDINGS`; one more says how many are left out."""
    views = [FindingView.model_validate(finding) for finding in findings[:MOST_FINDINGS]]
    if more := len(findings) - len(views):
        views.append(FindingView.model_validate(Finding("more", "info", f"… and {more:,} more")))
    return views


class FindingsView(ResponseModel):
    """All findings of the verifier about one machine."""

    findings: list[FindingView]
