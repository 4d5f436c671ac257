"""A log from elsewhere: every name in it is looked up before a tick is made, and what is unknown is named with its line."""

import pytest
from builders import role
from statwalk.errors import StageError
from statwalk.stage.replay import replay

ROLES = {"tiny": role()}
HEADER = '{"statwalk": "log", "semantics": 1, "head": 5}'
ADD = '{"tick":0,"kind":"add","actor":1,"name":"a","value":{"role":"tiny","position":[0,0,0],"heading":0}}'


def line(kind, name, value="null", actor=1):
    return f'{{"tick":2,"kind":"{kind}","actor":{actor},"name":"{name}","value":{value}}}'


def test_a_log_written_by_hand_can_be_played():
    assert replay([HEADER, ADD, line("press", "GO")], ROLES.__getitem__).actor(1).state == "WALK"


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        (line("press", "GOO"), "line 3: no event is called 'GOO'; did you mean GO?"),
        (line("hold", "END"), "line 3: no event is called 'END'"),
        (line("set", "pase", "1"), "line 3: no parameter is called 'pase'; did you mean pace?"),
        (line("travel", "WAKL"), "line 3: no state is called 'WAKL'; did you mean WALK?"),
        (line("press", "GO", actor=7), "line 3: no actor is called '7'. There are: 1"),
        (line("remove", "", actor=7), "line 3: no actor is called '7'"),
    ],
)
def test_an_unknown_name_is_named_with_its_line(entry, message):
    with pytest.raises(StageError) as error:
        replay([HEADER, ADD, entry], ROLES.__getitem__)
    assert str(error.value).startswith(message)
