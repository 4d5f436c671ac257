"""Generated API calls to a server in this process: schemathesis with all its checks, and one of our own.

One round asks every operation for the limits of its schema, for random bodies within and outside of it, and
for chains of requests (open a stage, use it, delete it, ask for it again).
"""

import asyncio
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpx
import schemathesis
import tiny_model
from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from schemathesis.config import SchemathesisConfig
from schemathesis.core import NotSet
from schemathesis.core.failures import Failure
from schemathesis.core.transport import Response
from schemathesis.engine import events, from_schema
from schemathesis.python.asgi import shutdown_lifespans
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

BY_SCHEMA = "x-refused-by-schema"
"""the header by which our check sees that no route ran"""
OWN = "http://localhost"
LONGEST_SECONDS = 120
CLIENT_ERRORS = ["400", "403", "404", "408", "409", "412", "413", "415", "421", "422", "428", "429"]
CHECKS = {
    # an unknown name in a body, a version that is old: 422 and 412 to a body that fits its schema
    "positive_data_acceptance": {"expected-statuses": ["2xx", *CLIENT_ERRORS, "503"]},
    "negative_data_rejection": {"expected-statuses": [*CLIENT_ERRORS, "405", "503"]},
    "missing_required_header": {"expected-statuses": ["422", "428"]},
}
CHAINS = 8
"""chains of requests for each random request of an operation"""
NAMES = {"name": "faq-walker", "stage_id": "main", "actor_id": 1}
CHARACTERS = {"include-path-regex": "^/api/characters/", "parameters": {"name": "tiny"}}
LONG = (
    {"include-path-regex": "^/api/characters/[^/]+/(rig|lod)$", "enabled": False},
    {"include-operation-id-regex": "^(put_character|import_machine)", "enabled": False},
    {"include-path-regex": "/step$", "enabled": False},
)
"""operations that start a process for each request, or make 36,000 ticks"""
MEASURING = {"include-path-regex": "/measure$", "parameters": {"query.cell": "STWK/END"}}
"""all cells take half a minute"""


class SchemaSilent(Failure):
    """The schema allows a request that the server's model refuses."""

    __slots__ = ()

    def __init__(self, operation: str, message: str) -> None:
        self.operation, self.message = operation, message
        self.title, self.code, self.case_id = "The schema allows what is refused", "schema_silent", None
        self.severity = schemathesis.core.failures.Severity.MEDIUM


@schemathesis.check
def schema_says_what_is_refused(_: Any, response: Response, case: Any) -> None:
    fits = case.meta is not None and case.meta.generation.mode.is_positive
    if not isinstance(case.body, NotSet) and not response.request.body:
        return  # bytes as text/plain are sent as nothing
    if fits and (BY_SCHEMA in response.headers or response.status_code in (400, 415)):
        raise SchemaSilent(case.operation.label, response.text[:300])


@dataclass
class Findings:
    """What came back: how many answers of each status by operation, and what is wrong."""

    statuses: Counter[tuple[str, int]] = field(default_factory=Counter)
    seconds: Counter[str] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)

    @property
    def cases(self) -> int:
        return sum(self.statuses.values())

    def add(self, other: "Findings") -> None:
        self.statuses += other.statuses
        self.seconds += other.seconds
        self.failures += other.failures


@contextmanager
def fuzzed_app(folder: Path) -> Iterator[Any]:
    """The server with a data folder, which marks what its models refuse; it stops at the end."""
    app = create_app(Settings(data=folder))
    inner = routes_of(app)
    refuse = inner.exception_handlers[RequestValidationError]

    def marked(request: Request, error: RequestValidationError) -> Any:
        answer = refuse(request, error)
        answer.headers[BY_SCHEMA] = "1"
        return answer

    inner.add_exception_handler(RequestValidationError, marked)
    asyncio.run(_prepare(app))
    try:
        yield app
    finally:
        shutdown_lifespans()


def routes_of(app: Any) -> FastAPI:
    """The application inside its guards."""
    while not isinstance(app, FastAPI):
        app = app.app
    return app


async def _prepare(app: Any) -> None:
    """An uploaded character, and a machine made from it."""
    kind = {"content-type": "model/gltf-binary"}
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url=OWN) as client:
        (
            await client.put("/api/characters/tiny", content=tiny_model.model(), headers=kind)
        ).raise_for_status()
        made = await client.post("/api/machines", json={"name": "made", "character": "tiny"})
        made.raise_for_status()


def fuzz(app: Any, seed: int, examples: int, *, quick: bool = False, **phases: bool) -> Findings:
    """One round of generated calls.

    `examples`: random requests of each operation; `quick`: without the `LONG` operations; `phases`: coverage,
    fuzzing, stateful; all unless told.
    """
    findings = Findings()
    config = {
        "seed": seed,
        "base-url": OWN,
        "suppress-health-check": ["all"],  # of the generator: a busy computer is slow
        "checks": CHECKS,
        "continue-on-failure": True,
        "request-timeout": LONGEST_SECONDS,
    }
    common = [MEASURING, *(LONG if quick else ())]
    chains = {"stateful": phases.pop("stateful", True)}
    calls = {"coverage": True, "fuzzing": True} | phases
    _run(app, config | {"parameters": NAMES, "operations": [CHARACTERS, *common]}, examples, calls, findings)
    # chains take the names from answers; all operations share them
    _run(app, config | {"operations": common}, CHAINS * examples, chains, findings)
    return findings


def _run(
    app: Any, config: dict[str, Any], examples: int, phases: dict[str, bool], findings: Findings
) -> None:
    if not any(phases.values()):
        return
    all_phases = dict.fromkeys(("examples", "coverage", "fuzzing", "stateful"), False) | phases
    made = {"generation": {"max-examples": examples, "database": "none", "no-shrink": True}}
    enabled = {"phases": {name: {"enabled": is_on} for name, is_on in all_phases.items()}}
    chosen = SchemathesisConfig.from_dict(config | made | enabled)
    schema = schemathesis.openapi.from_asgi(
        "/api/openapi.json", app, config=chosen, headers={"Host": "localhost"}
    )
    for event in from_schema(schema).execute():
        if isinstance(event, events.ScenarioFinished):
            _add_scenario(findings, event.recorder)
        elif isinstance(event, events.NonFatalError | events.FatalError):
            place, error = getattr(event, "label", ""), getattr(event, "value", None) or event.exception
            findings.failures.append(f"{place}: {error}")


def _add_scenario(findings: Findings, recorder: Any) -> None:
    for number, interaction in recorder.interactions.items():
        if interaction.response is not None:
            label = recorder.cases[number].value.operation.label
            findings.statuses[label, interaction.response.status_code] += 1
            findings.seconds[label] += interaction.response.elapsed
    findings.failures += _failures(recorder)


def _failures(recorder: Any) -> Iterator[str]:
    for number, checks in recorder.checks.items():
        case, interaction = recorder.cases[number].value, recorder.interactions[number]
        for check in checks:
            if check.failure_info is not None:
                answer = interaction.response
                got = (answer.status_code, answer.content[:300]) if answer else "nothing"
                yield (
                    f"{check.name}: {case.operation.label}: {check.failure_info.failure.message[:300]}\n"
                    f"  sent {case.path_parameters} {case.query} {repr(case.body)[:300]}\n  got {got}"
                )
