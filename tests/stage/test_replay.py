"""A log from elsewhere: every name in it is looked up before a tick is made, and what is unknown is named
with its line.
"""

import json

import pytest
from builders import role
from statwalk.errors import StageError
from statwalk.machine.definition.cell_definition import Defaults
from statwalk.services.library.load import load, shipped_machines_folder
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

ROLES = {"tiny": role()}
HEADER = '{"statwalk": "log", "semantics": 1, "head": 5}'
ADD = '{"number":1,"tick":0,"kind":"add","actor":1,"name":"a","role":"tiny","position":[0,0,0],"heading":0}'


def line(kind, actor=1, **fields):
    return json.dumps({"number": 2, "tick": 2, "kind": kind, "actor": actor, **fields})


def test_a_log_written_by_hand_can_be_played():
    assert replay([HEADER, ADD, line("press", event="GO")], ROLES.__getitem__).actor(1).state == "WALK"


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        (line("press", event="GOO"), "line 3: no event is called 'GOO'; did you mean GO?"),
        (line("hold", event="END"), "line 3: no event is called 'END'"),
        (line("set", parameter="pase", value=1), "line 3: no parameter is called 'pase'; did you mean pace?"),
        (line("travel", state="WAKL"), "line 3: no state is called 'WAKL'; did you mean WALK?"),
        (line("press", actor=7, event="GO"), "line 3: no actor is called '7'. There are: 1"),
        (line("remove", actor=7), "line 3: no actor is called '7'"),
    ],
)
def test_an_unknown_name_is_named_with_its_line(entry, message):
    with pytest.raises(StageError) as error:
        replay([HEADER, ADD, entry], ROLES.__getitem__)
    assert str(error.value).startswith(message)


def test_a_log_with_edits_of_a_shipped_machine_needs_nothing_but_load():
    text = (
        (shipped_machines_folder() / "faq-walker" / "machine.yaml")
        .read_text()
        .replace("STAT  | STWK ", "STAT  | CRCH ")
    )
    stage = Stage()
    actor = stage.add(load("faq-walker"))
    stage.step(10)
    stage.edit(load("faq-walker@2", text), text)
    stage.send(actor, "FORWARD")
    stage.step(10)
    assert actor.state == "CRCH"
    assert replay(stage.dump(), load).hash == stage.hash


# --- the hash of the head


@pytest.fixture
def walked():
    """A stage of 40 ticks, and its role."""
    stage = Stage(seed=3)
    stage.send(stage.add(ROLES["tiny"]), "GO")
    stage.step(40)
    return stage


def other_role(_name, _text=""):
    """The machine was edited since: another blend."""
    return role(defaults=Defaults(blend=0.4, buffer=0.3))


def test_a_log_that_leads_elsewhere_now_is_refused(walked):
    with pytest.raises(StageError) as refused:
        replay(walked.dump(), other_role)
    assert "leads to another state at tick 40 (" in str(refused.value)
    assert f"than the one it had ({walked.hash})" in str(refused.value)


def test_a_log_is_compared_only_at_its_head(walked):
    for until in (39, 41):
        assert replay(walked.dump(), other_role, until=until).tick == until


@pytest.mark.parametrize("how", [Stage.copy, Stage.fork, lambda stage: stage])
def test_a_log_has_the_hash_of_its_head_wherever_the_playhead_is(walked, how):
    end = walked.hash
    walked.seek(40)
    walked.seek(17)
    stage = how(walked)
    assert stage.head_hash == replay(stage.dump(), ROLES.__getitem__).hash
    assert (stage.head_hash == end) == (stage.head == 40)
    stage.seek(3)
    stage.step(stage.head)
    assert stage.head_hash == stage.hash == replay(stage.dump(), ROLES.__getitem__).hash
