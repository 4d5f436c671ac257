"""The findings of an answer: all of few, the first of many."""

import pytest
from statwalk.machine.lint.findings import Finding
from statwalk.web.schemas.finding import MOST_FINDINGS, finding_views


def findings(count: int) -> list[Finding]:
    return [Finding("unreachable", "warning", f"finding {number}", number) for number in range(count)]


@pytest.mark.parametrize("count", [0, 1, MOST_FINDINGS])
def test_few_findings_are_all_there(count: int) -> None:
    assert [view.line for view in finding_views(findings(count))] == list(range(count))


def test_of_many_findings_the_last_says_how_many_more_there_are() -> None:
    *first, last = finding_views(findings(MOST_FINDINGS + 17_700))
    assert [view.line for view in first] == list(range(MOST_FINDINGS))
    assert (last.kind, last.severity, last.message) == ("more", "info", "… and 17,700 more")
