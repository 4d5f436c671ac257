"""The table of refusals: rows that a reader can check, and no row for an operation that is not there."""

import pytest
from statwalk.web import refusals
from statwalk.web.app import openapi_document

DOCUMENT = openapi_document()
EVERY = {401, 403, 421, 429, 503}
CHANGE = {413, 415, 507}
BODY = CHANGE | {400, 422}
EXPECTED = {
    "GET /api/machines": EVERY,
    "GET /api/machines/{name}": EVERY | {404, 422},
    "PATCH /api/machines/{name}/cells": EVERY | BODY | {404, 409, 412, 428},
    "POST /api/machines/{name}/undo": EVERY | CHANGE | {404, 409, 412, 422, 428},
    "PUT /api/characters/{name}": EVERY | BODY | {408, 409},
    "POST /api/deduce": EVERY | BODY,
    "GET /api/stages/{stage_id}": EVERY | {404},
    "GET /api/stages/{stage_id}/frame.glb": EVERY | {404, 409, 422},
    "POST /api/stages/{stage_id}/events": EVERY | BODY | {404, 409},
    "DELETE /api/stages/{stage_id}/actors/{actor_id}": EVERY | CHANGE | {404, 409, 422},
}


def described(operation: str) -> set[int]:
    method, path = operation.split()
    return {int(status) for status in DOCUMENT["paths"][path][method.lower()]["responses"]}


@pytest.mark.parametrize("operation", EXPECTED)
def test_an_operation_lists_what_it_may_answer(operation: str) -> None:
    assert {status for status in described(operation) if status >= 400} == EXPECTED[operation]


@pytest.mark.parametrize("operation", [*refusals.OF_OPERATION, *refusals.NOT_OF_OPERATION])
def test_a_row_is_for_an_operation_that_is_there(operation: str) -> None:
    assert refusals.OF_OPERATION.get(operation, frozenset()) <= described(operation)


def test_each_status_has_a_meaning_and_is_used() -> None:
    used = {
        int(status)
        for operations in DOCUMENT["paths"].values()
        for operation in operations.values()
        for status in operation["responses"]
    }
    assert {status for status in used if status >= 400} == set(refusals.MEANINGS)
    assert {int(status) for status in DOCUMENT["components"]["responses"]} == set(refusals.MEANINGS)


def test_if_match_is_required() -> None:
    parameters = DOCUMENT["paths"]["/api/machines/{name}"]["put"]["parameters"]
    headers = {parameter["name"]: parameter for parameter in parameters if parameter["in"] == "header"}
    assert headers["If-Match"]["required"]
    assert headers["If-Match"]["schema"]["pattern"]
    assert not headers["Idempotency-Key"]["required"]
