"""JSON from strangers: what is refused, and that everything else reads as the standard reader reads it."""

import asyncio
import contextlib
import json
from time import thread_time

import pytest
from hostile import HOSTILE
from hypothesis import given
from hypothesis import strategies as st
from statwalk.web.bounded_json import DEEPEST, MOST_NAMES, MOST_VALUES, parse, parse_aside
from statwalk.web.errors import Problem


@pytest.mark.parametrize("body", HOSTILE.values(), ids=HOSTILE)
def test_hostile_json_is_refused(body: bytes) -> None:
    with pytest.raises(Problem) as refused:
        parse(body)
    assert refused.value.status_code == 400
    assert refused.value.field == "body"


def test_the_deepest_that_is_allowed_is_read() -> None:
    assert parse("[" * DEEPEST + "]" * DEEPEST)


@pytest.mark.parametrize("body", ["\ufeff{}", "\ufeff{}".encode()])
def test_a_byte_order_mark_is_refused_by_its_name(body: str | bytes) -> None:
    with pytest.raises(Problem, match="byte order mark"):
        parse(body)


def test_brackets_in_strings_do_not_nest() -> None:
    assert parse(json.dumps({"text": '[{"\\' * 200})) == {"text": '[{"\\' * 200}


TOO_MUCH = {
    "values": f"[{'0,' * MOST_VALUES}0]",
    "empty lists": f"[{'[],' * MOST_VALUES}[]]",
    "names": json.dumps({str(number): 0 for number in range(MOST_NAMES + 1)}),
}


@pytest.mark.parametrize("body", TOO_MUCH.values(), ids=TOO_MUCH)
def test_more_than_any_model_asks_for_is_refused(body: str) -> None:
    with pytest.raises(Problem, match="more than"):
        parse(body)


def test_commas_in_a_string_are_no_values() -> None:
    assert parse(json.dumps(["[{," * MOST_VALUES])) == ["[{," * MOST_VALUES]


def test_as_much_as_may_be_is_read() -> None:
    assert len(parse(f"[{'0,' * (MOST_VALUES - 3)}0]")) == MOST_VALUES - 2
    assert len(parse(json.dumps({str(number): 0 for number in range(MOST_NAMES)}))) == MOST_NAMES


NAMES = b",".join(b'"%d":0' % number for number in range(20_000))
LONG = {
    "a string of escaped quotes without an end": b'"' + b'\\"' * 32_000,
    "the same before a backslash": b'"' + b'\\"' * 32_000 + b"\\",
    "many names, the last one twice": b"{" + NAMES + b',"19999":1}',
}


@pytest.mark.parametrize("body", LONG.values(), ids=LONG)
def test_what_is_long_is_refused_in_no_time(body: bytes) -> None:
    """Each took from 7 to 20 s while the time grew with the square of the length; now it is 20 ms."""
    begun = thread_time()
    with pytest.raises(Problem):
        parse(body)
    assert thread_time() - begun < 0.5


def test_the_event_loop_goes_on_while_a_large_body_is_read() -> None:
    async def turns_meanwhile() -> int:
        reading = asyncio.ensure_future(parse_aside("[" + "{}," * 80_000 + "{}]"))
        turns = 0
        while not reading.done():
            await asyncio.sleep(0)
            turns += 1
        return turns

    assert asyncio.run(turns_meanwhile()) > 5


@pytest.mark.parametrize(
    ("text", "value"), [("30.0", 30), ("3e1", 30), ("-2.0", -2), ("0.0", 0), ("9e15", 9 * 10**15)]
)
def test_a_whole_number_is_an_integer_however_it_is_written(text: str, value: int) -> None:
    assert (parse(text), type(parse(text))) == (value, int)


@pytest.mark.parametrize("text", ["0.5", "1e300", "9.1e15"])
def test_other_numbers_stay_doubles(text: str) -> None:
    assert type(parse(text)) is float


VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(10**19), 10**19)
    | st.floats(allow_nan=False, allow_infinity=False)
    | st.text(),
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
