"""Logs as JSON lines: they come back as they were, and what is wrong is named with its line."""

import pytest
from statwalk.errors import StageError
from statwalk.stage.history.engine import ENGINE, RELEASE
from statwalk.stage.history.log_codec import dump, load
from statwalk.stage.state.commands import Add, Edit, Hold, LogEntry, Press, Release, Remove, Set, Travel

GO = ', "event": "GO"'
HEADER = '{"statwalk": "log", "semantics": 1}'


def line(kind, more="", tick="1", actor="1", number="1"):
    return f'{{"number":{number},"tick":{tick},"kind":"{kind}","actor":{actor}{more}}}'


def add(position="[0,0,0]"):
    return line("add", f', "name": "Ada", "role": "tiny", "heading": 0, "position": {position}')


COMMANDS = (
    Add(1, "Ada", "tiny", (0.0, 1.5, 2.0), 0.5),
    Press(1, "GO"),
    Hold(1, "GO"),
    Release(1, "GO"),
    Set(1, "pace", 1.25),
    Travel(1, "WALK"),
    Edit("tiny", "tiny@2", "a: b\n"),
    Remove(1),
)


def test_lines_come_back_as_they_were():
    log = [LogEntry(number, number // 3, command) for number, command in enumerate(COMMANDS, 1)]
    loaded = load(dump(log, {"seed": 3, "rate": 60}))
    made_by = {"engine": ENGINE, "version": RELEASE}
    assert loaded.header == {"statwalk": "log", "semantics": 1, **made_by, "seed": 3, "rate": 60}
    assert loaded.entries == log


def test_blank_lines_count():
    assert load([HEADER, "", line("press", GO)]).lines == [3]


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([], "line 1: not a statwalk log"),
        (['{"tick": 1}'], "line 1: not a statwalk log"),
        (["{"], "line 1: "),
        (["[]"], "line 1: a JSON object is needed"),
        (['{"statwalk": "log", "semantics": 9}'], "semantics 9, this build reads 1"),
        (
            ['{"statwalk": "log", "semantics": 1, "rate": 0}'],
            "line 1: rate is a whole number of at least 1, not 0",
        ),
        (['{"statwalk": "log", "semantics": 1, "seed": 1.5}'], "line 1: seed is a whole number"),
        (['{"statwalk": "log", "semantics": 1, "hash": 7}'], "line 1: hash is text"),
        (['{"statwalk": "log", "semantics": 1, "head": -1}'], "line 1: head is a whole number of at least 0"),
        ([HEADER, '{"tick": 1}'], "line 2: an entry has number and tick"),
        ([HEADER, line("jump")], "press, hold, release"),
        ([HEADER, line("press", GO, tick='"1"')], "line 2: an entry has number and tick"),
        ([HEADER, line("press", GO, tick="true")], "line 2: an entry has number and tick"),
        ([HEADER, line("press", GO, number="-1")], "line 2: an entry has number and tick"),
        ([HEADER, line("press", GO, actor="-1")], "line 2: actor is a whole number of at least 0"),
        ([HEADER, line("press", GO, actor="1e400")], "line 2: "),
        ([HEADER, line("press", ', "event": 3')], "line 2: event is text"),
        ([HEADER, "", '{"tick": 1}'], "line 3: an entry has number and tick"),
        ([HEADER, line("press")], "line 2: press has actor, event beside number, tick and kind"),
        ([HEADER, line("press", GO + ', "value": 1')], "line 2: press has actor, event"),
        (
            [HEADER, line("set", ', "parameter": "pace", "value": "fast"')],
            "line 2: value is a finite number, not fast",
        ),
        ([HEADER, line("set", ', "parameter": "pace", "value": true')], "line 2: value is a finite number"),
        ([HEADER, line("add")], "line 2: add has actor, name, role, position, heading"),
        ([HEADER, add("[0,0]")], "line 2: position is three finite numbers"),
        ([HEADER, add("[0,0,null]")], "line 2: position is three finite numbers"),
    ],
)
def test_a_bad_line_is_named(lines, message):
    with pytest.raises(StageError) as error:
        load(lines)
    assert message in str(error.value)
