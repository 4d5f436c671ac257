"""JSON from strangers: what is refused, and that everything else reads as the standard reader reads it."""

import contextlib
import json

import pytest
from hostile import HOSTILE
from hypothesis import given
from hypothesis import strategies as st
from statwalk.web.jsonbody import DEEPEST, parse
from statwalk.web.problem import Problem


@pytest.mark.parametrize("body", HOSTILE.values(), ids=HOSTILE)
def test_hostile_json_is_refused(body: bytes) -> None:
    with pytest.raises(Problem) as refused:
        parse(body)
    assert refused.value.status_code == 400
    assert refused.value.field == "body"


def test_the_deepest_that_is_allowed_is_read() -> None:
    assert parse("[" * DEEPEST + "]" * DEEPEST)


def test_brackets_in_strings_do_not_nest() -> None:
    assert parse(json.dumps({"text": '[{"\\' * 200})) == {"text": '[{"\\' * 200}


VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**19), 10**19) | st.floats(allow_nan=False, allow_infinity=False) | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(VALUES)
def test_ordinary_json_reads_as_it_was_written(value: object) -> None:
    assert parse(json.dumps(value).encode()) == value


@given(st.binary(max_size=200))
def test_any_bytes_are_read_or_refused(data: bytes) -> None:
    with contextlib.suppress(Problem):
        parse(data)
