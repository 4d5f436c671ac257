"""A stage's state as bytes: what comes back is the same to the bit, and what does not fit is refused."""

import json
from contextlib import suppress

import numpy as np
import pytest
from playing import role_of
from statwalk.errors import StageError
from statwalk.services.library.load import load
from statwalk.stage.history.cast_codec import from_arrays, to_arrays
from statwalk.stage.history.engine import ENGINE
from statwalk.stage.history.state_codec import from_bytes, to_bytes
from statwalk.stage.stage import Stage
from statwalk.stage.state import pending_events
from statwalk.stage.state.pending_events import NOTICE_REASONS, Notice
from statwalk.stage.state.stage_state import StageState
from wild_machines import inputs, machine

SEEDS = range(4)


def wild_stage(seed):
    stage = Stage(seed=seed)
    role = role_of(machine(seed), "wild")
    for number in range(3):
        stage.add(role, (0.3 * number, 0.0, 0.0))
    return stage


def tell(stage, told):
    for kind, actor, name, value in told:
        more = [value] if kind == "set" else []
        with suppress(StageError):  # travel: there may be no way
            getattr(stage, "send" if kind == "press" else kind)(actor, name, *more)


def through_bytes(stage):
    stage._state = from_bytes(to_bytes(stage.state), stage.roles)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_stage_that_goes_through_bytes_at_every_tick_lives_the_same_life(seed):
    usual, written = wild_stage(seed), wild_stage(seed)
    for told in inputs(seed, 240, 3).values():
        for stage in (usual, written):
            tell(stage, told)
            stage.step()
        through_bytes(written)
        assert written.hash == usual.hash


def test_a_thousand_ticks_through_bytes_are_those_without():
    usual, written = Stage(seed=2), Stage(seed=2)
    role = load("faq-walker")
    for stage in (usual, written):
        stage.add(role)
    for tick in range(1_200):
        for stage in (usual, written):
            if tick % 97 == 0:
                stage.send(1, ("FORWARD", "LEFT", "STOP", "JUMP")[tick // 97 % 4])
            stage.step()
        through_bytes(written)
    assert written.hash == usual.hash


def test_what_was_written_is_written_the_same_again():
    stage = wild_stage(1)
    stage.step(30)
    data = to_bytes(stage.state)
    assert to_bytes(from_bytes(data, stage.roles)) == data


def test_names_and_the_next_id_come_back():
    stage = wild_stage(1)
    back = from_bytes(to_bytes(stage.state), stage.roles)
    assert (back.names, back.next_id) == (stage.state.names, 4)


@pytest.mark.parametrize("cut", [0, 5, 16, 200, -1])
def test_bytes_that_are_cut_off_are_refused(cut):
    stage = wild_stage(1)
    with pytest.raises(StageError, match="hold no stage"):
        from_bytes(to_bytes(stage.state)[:cut], stage.roles)


def test_another_version_of_the_format_is_refused():
    stage = wild_stage(1)
    with pytest.raises(StageError, match="version 7; this build reads version 3"):
        from_bytes(to_bytes(stage.state).replace(b'"version":3', b'"version":7'), stage.roles)


def test_a_state_of_another_engine_is_refused():
    """Its numbers may be others."""
    stage = wild_stage(1)
    another = int("9" * len(str(ENGINE)))  # with as many digits: the state says how long it is
    other = to_bytes(stage.state).replace(b'"engine":%d' % ENGINE, b'"engine":%d' % another)
    with pytest.raises(StageError, match=f"engine {another} made the stage; this is engine {ENGINE}"):
        from_bytes(other, stage.roles)


def test_a_role_that_is_not_here_is_named():
    stage = wild_stage(1)
    with pytest.raises(StageError, match="plays 'wild', which is not here"):
        from_bytes(to_bytes(stage.state), {})


def test_a_role_of_another_shape_is_refused():
    stage = wild_stage(1)
    other = role_of(
        "character: c.glb\ninitial: A\nstates: {A: {motion: stand}}\ntable: |\n  state | X | END\n  A | | \n",
        "wild",
    )
    with pytest.raises(StageError, match="wild has another shape"):
        from_bytes(to_bytes(stage.state), {"wild": other})


NOTICE = Notice(1, "WAVE", 2, pending_events.NOBODY_IS_CALLED, target="Bob {event}")


def test_notices_are_stored_as_codes():
    data = to_bytes(StageState(notices=(NOTICE,)))
    assert from_bytes(data, {}).notices == (NOTICE,)
    assert b"nobody" not in data


def test_a_reason_that_there_is_not_is_refused():
    for reason in (NOTICE_REASONS.stop, -1, "there is no other", None):
        with pytest.raises(StageError, match="no reason of a notice"):
            from_bytes(to_bytes(StageState(notices=(NOTICE._replace(reason=reason),))), {})


def with_values(name, value):
    """The bytes of a stage with an actor, with one value in the place of all of an array's."""
    stage = wild_stage(0)
    stage.step(3)
    (key,) = stage.state.casts
    arrays = to_arrays(stage.state.casts[key])
    arrays[name] = np.full_like(arrays[name], value)
    return key, stage.roles[key], arrays


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("machine.state", 0x7F7F),
        ("machine.state", -1),
        ("machine.stayed", 1 << 30),
        ("machine.ended", 9),
        ("machine.goal", 0x7F7F),
        ("machine.time", np.nan),
        ("machine.parameters", np.inf),
        ("position", 1e300),
        ("ids", 1),
        ("shown", np.nan),
    ],
)
def test_values_that_no_stage_writes_are_refused(name, value):
    key, role, arrays = with_values(name, value)
    with pytest.raises(StageError, match=key):
        from_arrays(key, role, arrays)


@pytest.mark.parametrize(
    ("name", "value"),
    [("tick", "x"), ("tick", 2**70), ("next_id", None), ("action_count", 1.5), ("next_id", 2)],
)
def test_headers_that_no_stage_writes_are_refused(name, value):
    stage = wild_stage(0)
    data = to_bytes(stage.state)
    length = int.from_bytes(data[8:16], "little")
    header = json.loads(data[16 : 16 + length]) | {name: value}
    text = json.dumps(header).encode()
    filled = text + b" " * (-len(text) % 8)
    rest = data[16 + length + (-length % 8) :]
    with pytest.raises(StageError):
        from_bytes(data[:8] + len(filled).to_bytes(8, "little") + filled + rest, stage.roles)


@pytest.mark.parametrize("kind", ["<f8,(", "|O", "<U9", "|V1", "<M8", "<c16"])
def test_kinds_of_arrays_that_no_stage_writes_are_refused(kind):
    stage = wild_stage(0)
    data = to_bytes(stage.state)
    length = int.from_bytes(data[8:16], "little")
    header = json.loads(data[16 : 16 + length])
    header["arrays"][0][1] = kind
    text = json.dumps(header).encode()
    with pytest.raises(StageError):
        from_bytes(data[:8] + len(text).to_bytes(8, "little") + text + bytes(1 << 20), stage.roles)
