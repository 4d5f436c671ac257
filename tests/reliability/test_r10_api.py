"""R-10: no generated call gets a 500, an undocumented answer, or an answer that does not fit its schema.

The script asks for more: `python benchmarks/reliability.py api --cases 50000`.
"""

from collections.abc import Iterator
from typing import Any

import pytest
from api_fuzz import fuzz, fuzzed_app, routes_of
from statwalk.web.dependencies import registry_of
from statwalk.web.errors import Problem

SEED = 11
LEAST_CASES = 1_000


@pytest.fixture(scope="module")
def app(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    with fuzzed_app(tmp_path_factory.mktemp("data")) as app:
        yield app


@pytest.fixture
def faults(app: Any) -> Iterator[dict[Any, Any]]:
    """What a test puts in place of the server's dependencies."""
    overrides = routes_of(app).dependency_overrides
    yield overrides
    overrides.clear()


@pytest.mark.timeout(400)  # some 2,000 calls: 15 s where nothing else runs
def test_every_answer_is_described(app: Any) -> None:
    findings = fuzz(app, SEED, 2, quick=True)
    assert findings.failures == []
    assert findings.cases >= LEAST_CASES
    assert {status for _, status in findings.statuses} >= {200, 201, 202, 204, 404, 405, 409, 412, 422, 428}


PLANTED = {
    "a defect": ZeroDivisionError("planted"),
    "an answer that no document names": Problem(418, "planted"),
}


@pytest.mark.parametrize("fault", PLANTED.values(), ids=PLANTED)
def test_a_planted_fault_is_found(app: Any, faults: dict[Any, Any], fault: Exception) -> None:
    """The control: whatever needs the stages gets the fault."""

    def broken() -> None:
        raise fault

    faults[registry_of] = broken
    findings = fuzz(app, SEED, 1, quick=True, coverage=False, stateful=False)
    assert any("planted" in failure for failure in findings.failures)
