"""Verdicts are words when they are read, however much later; until then they are codes."""

import pytest
from playing import TABLE, role_of, text_of
from statwalk.stage.effects.words import notice_sentence, touch_sentence
from statwalk.stage.stage import Stage
from statwalk.stage.state import pending_events
from statwalk.stage.state.pending_events import Notice, PendingEvent

RAISES = role_of(text_of(TABLE, more='cells:\n  STAND/GO: {to: WALK, action: "raise(TURN, Bob)"}'))


@pytest.mark.parametrize(
    ("reason", "words"),
    [
        (pending_events.NO_OTHER, "there is no other"),
        (pending_events.NOBODY_KNOWS, "no other actor knows WAVE"),
        (pending_events.NOBODY_IS_CALLED, "no actor is called Bob {role}"),
        (pending_events.TOO_MANY_RAISED, "more than 16 events were raised on it in one tick"),
        (pending_events.NO_SUCH_EVENT, "{tiny} has no event WAVE"),
        (pending_events.NO_SUCH_STATE, "{tiny} has no state WAVE"),
        (pending_events.STATE_IS_GONE, "the edit has no state SIT"),
        (pending_events.EVENT_IS_GONE, "the edit has no such event"),
    ],
)
def test_every_reason_of_a_notice_has_a_sentence(reason, words):
    notice = Notice(1, "WAVE", 2, reason, 0, "SIT", "STAND", "Bob {role}")
    assert notice_sentence(notice, "{tiny}") == words


def test_a_touch_says_where_and_when():
    event = PendingEvent(1, "HIT", 2, 0, (0.384, -1.0, 12.5), 0.25)
    assert touch_sentence(event) == "touched at 0.38, -1.00, 12.50 m, 0.25 into the tick"


def test_a_notice_that_is_read_late_names_the_state_of_its_tick():
    stage = Stage()
    actor = stage.add(RAISES)
    stage.send(actor, "GO")
    stage.step()
    stage.send(actor, "HOP")
    stage.step()
    assert actor.state == "HOP"
    notice = stage.verdicts[0]
    assert (notice.tick, notice.from_state, notice.reason) == (1, "WALK", "no actor is called Bob")
