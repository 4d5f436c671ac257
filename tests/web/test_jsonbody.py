"""JSON from strangers: what is refused, and that everything else reads as the standard reader reads it."""

import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st
from statwalk.web.jsonbody import DEEPEST, parse
from statwalk.web.problem import Problem

HOSTILE = {
    "NaN": b'{"a": NaN}',
    "Infinity": b"[Infinity]",
    "minus Infinity": b"[-Infinity]",
    "overflow": b"[1e999]",
    "deep arrays": b"[" * 100_000,
    "deep objects": b'{"a":' * 500 + b"1" + b"}" * 500,
    "just too deep": b"[" * (DEEPEST + 1) + b"]" * (DEEPEST + 1),
    "bad UTF-8": b'{"a": "\xff\xfe"}',
    "surrogates as UTF-8": b'"\xed\xa0\x80"',
    "lone surrogate": b'{"event": "\\ud800"}',
    "lone surrogate in a name": b'{"\\udfff": 1}',
    "5000 digits": b"[" + b"9" * 5_000 + b"]",
    "21 digits": b"[-" + b"1" * 21 + b"]",
    "a name twice": b'{"tick": 1, "tick": 2}',
    "byte order mark": b"\xef\xbb\xbf{}",
    "cut short": b'{"a": [1, 2',
    "empty": b"",
    "two values": b"1 2",
    "a control character": b'"\x00"',
    "unclosed string": b'"' + b"[" * 1_000,
}


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
