"""A cast as arrays: only the places in use are there and come back exactly; counts that lie are refused."""

import numpy as np
import pytest
from playing import TABLE, role_of, text_of
from statwalk.errors import StageError
from statwalk.stage.history.cast_codec import PENDING, from_arrays, to_arrays
from statwalk.stage.history.state_codec import from_bytes, to_bytes
from statwalk.stage.stage import Stage

ROLE = role_of(text_of(TABLE))
LAYERED = role_of(
    text_of(
        TABLE,
        more="""layers:
  face:
    mask: [arm]
    initial: CALM
    states: {CALM: {motion: none}, NOD: {motion: turn}}
    table: |
      state | NOD | END
      CALM  | NOD |
      NOD   |     | CALM
""",
    ),
    "layered",
)


def stage_of(role, waiting, actors=3):
    """The second actor hops, so that these events wait for it; the others stand, and nothing waits for
    them.
    """
    stage = Stage()
    stage.add_many(role, [((number, 0, 0), 0) for number in range(actors)])
    stage.send(2, "HOP")
    stage.step()
    for event in waiting:
        stage.send(2, event)
    stage.step()
    return stage


def cast_of(role=ROLE, waiting=("GO", "TURN"), actors=3):
    return stage_of(role, waiting, actors).casts[0].state


def test_only_the_places_in_use_are_stored():
    arrays = to_arrays(cast_of())
    assert arrays["machine.waiting"].tolist() == [[0], [2], [0]]
    assert [ROLE.machine.events[event] for event in arrays["machine.waiting_event"]] == ["GO", "TURN"]
    assert {name: arrays[name].shape for name in PENDING} == dict.fromkeys(PENDING, (2,))


def test_an_empty_queue_takes_no_room():
    """A place of an event has 2 + 1 + 8 + 1 + 8 bytes; a thousand actors would have sixteen each."""
    sizes = [len(to_bytes(stage_of(ROLE, waiting).state)) for waiting in ((), ("GO", "TURN"))]
    assert sizes[1] - sizes[0] == 2 * 8 + 2 * 8 + 3 * 8  # of two places, each array a multiple of 8 bytes
    assert sum(to_arrays(cast_of(waiting=()))[name].nbytes for name in PENDING) == 0


@pytest.mark.parametrize(
    ("role", "waiting"),
    [
        (ROLE, ()),
        (ROLE, ("GO",)),
        (ROLE, ("GO", "TURN", "STOP")),
        (LAYERED, ("GO", "NOD")),
        (LAYERED, ("NOD",) * 3),
    ],
)
@pytest.mark.parametrize("actors", [2, 17])
def test_what_was_taken_apart_comes_back_exactly(role, waiting, actors):
    cast = cast_of(role, waiting, actors)
    back = from_arrays(role.name, role, to_arrays(cast))
    assert all(
        np.array_equal(before, after) and before.dtype == after.dtype
        for before, after in zip(cast.machine, back.machine, strict=True)
    )


def test_a_full_queue_comes_back():
    crowded = role_of(
        text_of(
            "state | " + " | ".join(f"X{n}" for n in range(18)) + " | END\nA |" + "|" * 18,
            "",
            "states: {A: {motion: stand}}\ndefaults: {buffer: 5}",
            "A",
        ),
        "crowded",
    )
    stage = Stage()
    stage.add(crowded)
    for number in range(18):
        stage.send(1, f"X{number}")
    stage.step()
    machine = stage.casts[0].machine
    assert machine.waiting.tolist() == [[16]]
    back = from_bytes(to_bytes(stage.state), stage.roles).casts["crowded"].machine
    assert back.waiting_event.tolist() == machine.waiting_event.tolist()
    assert back.waiting_until.tolist() == machine.waiting_until.tolist()


def with_counts(counts):
    arrays = to_arrays(cast_of())
    arrays["machine.waiting"] = np.array(counts, np.int8)
    return arrays


@pytest.mark.parametrize(
    ("counts", "message"),
    [
        ([[0], [17], [0]], "17 events wait in one layer; there is room for 0 … 16"),
        ([[0], [-1], [0]], "-1 events wait in one layer"),
        ([[0], [3], [0]], "machine.waiting_event has 2 rows, and the counts add up to 3"),
        ([[0], [0], [0]], "machine.waiting_event has 2 rows, and the counts add up to 0"),
    ],
)
def test_counts_that_lie_are_refused(counts, message):
    with pytest.raises(StageError, match=message):
        from_arrays("tiny", ROLE, with_counts(counts))


@pytest.mark.parametrize("name", [*PENDING, "offsets.start", "offsets.rate"])
def test_rows_that_are_missing_are_refused(name):
    arrays = to_arrays(cast_of())
    arrays[name] = arrays[name][:-1]
    with pytest.raises(StageError, match=f"{name} has {len(arrays[name])} rows, and the counts"):
        from_arrays("tiny", ROLE, arrays)


def test_rows_of_another_kind_are_refused():
    arrays = to_arrays(cast_of())
    arrays["machine.waiting_until"] = arrays["machine.waiting_until"].astype(np.float64)
    with pytest.raises(StageError, match=r"tiny has another shape: machine\.waiting_until is float64"):
        from_arrays("tiny", ROLE, arrays)


def test_every_cut_of_the_bytes_is_refused():
    stage = stage_of(ROLE, ("GO", "TURN"))
    data = to_bytes(stage.state)
    for cut in range(0, len(data) - 8, 97):
        with pytest.raises(StageError):
            from_bytes(data[:cut], stage.roles)
