"""Events that actors raise on each other: they count in the next tick, and what reaches nobody is told."""

import pytest
from playing import TABLE, role_of, text_of
from statwalk.stage.stage import Stage
from statwalk.stage.steps.raise_events import MOST_RAISED

CALLER = """
state | GO   | HOP  | END
STAND | WALK | HOP  |
WALK  |      |      |
HOP   |      |      | STAND
"""


def caller(action, name="caller"):
    """Whose GO does `raise(…)`."""
    return role_of(text_of(CALLER, more=f'cells:\n  STAND/GO: {{to: WALK, action: "{action}"}}'), name)


PLAIN = role_of(text_of(TABLE))


def calling(action, others=2, role=PLAIN):
    """Somebody who raises in tick 1, and others, the first of them called Ada."""
    stage = Stage()
    one = stage.add(caller(action))
    rest = [stage.add(role, name="Ada" if number == 0 else None) for number in range(others)]
    stage.send(one, "GO")
    stage.step()
    return stage, one, rest


def test_it_counts_in_the_next_tick():
    stage, _, (ada, other) = calling("raise(TURN, Ada)")
    assert ada.state == "STAND"
    stage.step()
    assert (ada.state, other.state) == ("TURN", "STAND")


def test_the_verdict_says_who_raised_it():
    stage, one, _ = calling("raise(TURN, Ada)")
    stage.step()
    (verdict,) = stage.frame.verdicts
    assert (verdict.event, verdict.verdict, verdict.other) == ("TURN", "taken", one.id)


def test_all_means_everybody_else_who_knows_it():
    stage, _, (ada, other) = calling("raise(HOP, all)")
    assert [raised.actor for raised in stage.state.inbox] == [ada.id, other.id]
    stage.step()
    assert (ada.state, other.state) == ("HOP", "HOP")


def test_other_is_who_raised_the_event_that_the_cell_answers():
    answering = role_of(text_of(TABLE, more='cells:\n  STAND/TURN: {to: TURN, action: "raise(HOP, other)"}'))
    stage, one, (ada, _) = calling("raise(TURN, Ada)", role=answering)
    stage.step()
    assert ada.state == "TURN"
    stage.step()
    (verdict,) = [verdict for verdict in stage.frame.verdicts if verdict.actor == one.id]
    assert (verdict.event, verdict.verdict, verdict.other) == ("HOP", "waits", ada.id)


def test_an_action_that_raises_is_an_action_too():
    stage, one, _ = calling("raise(TURN, Ada)")
    (action,) = stage.frame.actions
    assert (action.actor, action.name, action.arguments) == (one.id, "raise", ("TURN", "Ada"))


def test_who_has_no_such_event_drops_it_with_a_verdict():
    stage, _, (ada, _) = calling("raise(FROWN, Ada)")
    stage.step()
    (verdict,) = stage.frame.verdicts
    assert (verdict.actor, verdict.event, verdict.verdict, verdict.reason) == (
        ada.id,
        "FROWN",
        "dropped",
        "tiny has no event FROWN",
    )


@pytest.mark.parametrize(
    ("action", "reason"),
    [
        ("raise(TURN, Bob)", "no actor is called Bob"),
        ("raise(TURN, other)", "there is no other"),
        ("raise(FROWN, all)", "no other actor knows FROWN"),
    ],
)
def test_what_reaches_nobody_is_told_to_the_raiser(action, reason):
    stage, one, _ = calling(action)
    lost = stage.frame.verdicts[0]
    assert (lost.actor, lost.verdict, lost.reason) == (one.id, "dropped", reason)


def test_who_has_left_meanwhile_is_not_missed():
    stage, _, (ada, other) = calling("raise(TURN, Ada)")
    stage.remove(ada)
    stage.step()
    assert (other.state, stage.frame.verdicts) == ("STAND", ())


def test_nobody_gets_more_than_can_wait():
    stage = Stage()
    callers = stage.add_many(caller("raise(HOP, Ada)"), [((0, 0, 0), 0)] * (MOST_RAISED + 5))
    stage.add(PLAIN, name="Ada")
    for one in callers:
        stage.send(one, "GO")
    stage.step()
    assert len(stage.state.inbox) == MOST_RAISED
    assert [one.reason for one in stage.frame.verdicts if one.verdict == "dropped"] == [
        f"more than {MOST_RAISED} events were raised on it in one tick"
    ]


def test_a_crowd_that_raises_on_all_costs_no_more_than_its_events():
    stage = Stage()
    crowd = stage.add_many(caller("raise(HOP, all)"), [((0, 0, 0), 0)] * 300)
    for one in crowd:
        stage.send(one, "GO")
    stage.step()
    assert len(stage.state.inbox) == 300 * MOST_RAISED
