"""Keys of a machine file that change parameters: what is read, and what is refused where."""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine

TEXT = """\
initial: STAY
states: {{STAY: {{motion: stay}}, LIFT: {{motion: lift}}}}
parameters:
  pace: {{default: 1, min: 0, max: 4}}
  aim: {{kind: point, default: [0, 1, 0], min: -5, max: 5}}
  side: {{kind: direction, default: [0, 0, -1]}}
  calm: {{kind: flag}}
table: |
  state | GO   | END
  STAY  | LIFT |
  LIFT  | STAY |
layers:
  arms:
    initial: AWAY
    states: {{AWAY: {{motion: none}}}}
    table: |
      state | GO
      AWAY  | AWAY
keys:
  ArrowUp: {key}
"""


def read(key):
    return read_machine(TEXT.format(key=key)).keys["ArrowUp"]


def test_changes_by_state_in_the_order_of_the_file():
    key = read("{change: {AWAY: {aim.x: -0.5, pace: 2}, LIFT: {pace: 1}, '*': {aim.y: 3}}}")
    assert (key.press, key.release, key.hold) == (None, None, False)
    assert list(key.change.items()) == [
        ("AWAY", {"aim.x": -0.5, "pace": 2}),
        ("LIFT", {"pace": 1}),
        ("*", {"aim.y": 3}),
    ]


def test_a_key_with_an_event_changes_nothing():
    assert read("{hold: GO}").change == {}


@pytest.mark.parametrize(
    ("key", "words"),
    [
        ("{change: {}}", "`change` needs a state"),
        ("{change: {STAY: {pace: 1}}, press: GO}", "sends no events"),
        ("{change: {STAI: {pace: 1}}}", "did you mean STAY"),
        ("{change: {STAY: {pase: 1}}}", "did you mean pace"),
        ("{change: {STAY: {aim: 1}}}", "'aim'"),
        ("{change: {STAY: {side.x: 1}}}", "'side.x'"),
        ("{change: {STAY: {calm: 1}}}", "'calm'"),
        ("{change: {STAY: {pace: fast}}}", "fast"),
        ("{change: {STAY: {pace: 1e9}}}", "finite number"),
        ("{release: GO}", "`change: …`"),
    ],
)
def test_what_is_refused(key, words):
    with pytest.raises(MachineError, match=words) as caught:
        read(key)
    assert "line 20" in str(caught.value)
