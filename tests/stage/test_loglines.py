"""Logs as JSON lines: they come back as they were, and what is wrong is named with its line."""

import pytest
from statwalk.errors import StageError
from statwalk.stage.past.log import LogEntry
from statwalk.stage.past.loglines import dump, load

HEADER = '{"statwalk": "log", "semantics": 1}'


def line(kind, value="null", tick="1", actor="1", name='"GO"'):
    return f'{{"tick":{tick},"kind":"{kind}","actor":{actor},"name":{name},"value":{value}}}'


def test_lines_come_back_as_they_were():
    log = [
        LogEntry(0, "add", 1, "Ada", {"role": "tiny", "position": [0.0, 1.5, 2.0], "heading": 0.5}),
        LogEntry(1, "press", 1, "GO"),
        LogEntry(2, "set", 1, "pace", 1.25),
        LogEntry(3, "travel", 1, "WALK"),
        LogEntry(3, "edit", 0, "tiny", {"role": "tiny@2", "text": "a: b\n"}),
    ]
    loaded = load(dump(log, {"seed": 3, "rate": 60}))
    assert loaded.header == {"statwalk": "log", "semantics": 1, "kernels": "numpy", "seed": 3, "rate": 60}
    assert loaded.entries == log


def test_blank_lines_count():
    assert load([HEADER, "", line("press")]).lines == [3]


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ([], "line 1: not a statwalk log"),
        (['{"tick": 1}'], "line 1: not a statwalk log"),
        (["{"], "line 1: "),
        (["[]"], "line 1: a JSON object is needed"),
        (['{"statwalk": "log", "semantics": 9}'], "semantics 9, this build reads 1"),
        (['{"statwalk": "log", "semantics": 1, "rate": 0}'], "line 1: rate is a whole number of at least 1, not 0"),
        (['{"statwalk": "log", "semantics": 1, "seed": 1.5}'], "line 1: seed is a whole number"),
        (['{"statwalk": "log", "semantics": 1, "head": -1}'], "line 1: head is a whole number of at least 0"),
        ([HEADER, '{"tick": 1}'], "line 2: an entry has tick"),
        ([HEADER, line("jump")], "press, hold, release"),
        ([HEADER, line("press", tick='"1"')], "line 2: tick and actor"),
        ([HEADER, line("press", tick="true")], "line 2: tick and actor"),
        ([HEADER, line("press", actor="-1")], "line 2: tick and actor"),
        ([HEADER, line("press", actor="1e400")], "line 2: "),
        ([HEADER, line("press", name="3")], "name is text"),
        ([HEADER, "", '{"tick": 1}'], "line 3: an entry has tick"),
        ([HEADER, line("press", "1")], "line 2: the value of press is null, not 1"),
        ([HEADER, line("set", '"fast"')], "line 2: the value of set is a finite number, not fast"),
        ([HEADER, line("set", "true")], "the value of set is a finite number"),
        ([HEADER, line("add", "{}")], "the value of add is role, position (x, y, z) and heading"),
        ([HEADER, line("add", '{"role":"tiny","position":[0,0],"heading":0}')], "the value of add is"),
        ([HEADER, line("add", '{"role":"tiny","position":[0,0,null],"heading":0}')], "the value of add is"),
        ([HEADER, line("edit", '{"role":"tiny@2","text":7}')], "the value of edit is role"),
    ],
)
def test_a_bad_line_is_named(lines, message):
    with pytest.raises(StageError) as error:
        load(lines)
    assert message in str(error.value)
