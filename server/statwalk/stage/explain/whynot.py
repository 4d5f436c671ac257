"""Why not: the reason for which an event did not fire in a tick, and the single changes that would have made
it fire, tried from the cheapest on.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.definition.machine_definition import END
from statwalk.stage.advance import advance
from statwalk.stage.explain.counterfactual import Attempt, Budget
from statwalk.stage.explain.past_states import PastStates
from statwalk.stage.explain.remedies import Candidate, Question, candidates, sense_of, sensed
from statwalk.stage.explain.remedy_words import text_of
from statwalk.stage.stage import Stage
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import Command, Press
from statwalk.stage.state.frame import Verdict

MOST_REMEDIES = 8
WORDS = {
    "moment": "a later tick",
    "hold": "holding it down",
    "state": "going to another state",
    "buffer": "letting it wait longer",
    "cell": "another cell",
}
"""the kinds of changes after which an event is watched"""


class Remedy(NamedTuple):
    """One change that makes the event fire.

    `change`: see `counterfactual.tried`; `fires`: the tick in which the event fired in the fork.
    """

    kind: str
    text: str
    change: dict[str, Any]
    fires: int


class WhyNot(NamedTuple):
    """The verdict on the event, and what would have made it fire; `remedies` is empty if the event fired, or
    if no change helps. `cut`: the changes that were not tried to the end, in words.
    """

    fired: bool
    reason: str
    remedies: tuple[Remedy, ...]
    cut: str = ""


def whynot(stage: Stage, actor: int, event: str, tick: int) -> WhyNot:
    """Returns why `event`, sent or not, did not fire for an actor in `tick` (from 1 on). Every remedy was
    tried in a fork and works.

    :raises StageError: when the stage does not have the tick.
    :raises UnknownNameError: when the actor does not exist at the tick, or its machine does not have the
        event.
    """
    question, came = _asked(stage, actor, event, tick)
    if came and question.verdict.verdict == "taken":
        return WhyNot(True, _summary(question.verdict), ())
    budget = Budget.of(question.past.look_at(tick - 1), stage.rate)
    if question.verdict.verdict == "taken":
        possible = [Candidate(0.0, {"kind": "send", "event": event, "tick": tick}), *sensed(question)]
        reason = sense_of(question) or "it was not sent in this tick"
    else:
        possible = sorted(candidates(question, budget), key=lambda candidate: candidate.cost)
        reason = (
            _summary(question.verdict)
            if came
            else f"it was not sent in this tick; if it had been: {_summary(question.verdict)}"
        )
    remedies = _tried(question, came, possible, budget)
    return WhyNot(False, reason, remedies, _cut(budget))


def _tried(
    question: Question, came: bool, possible: Iterable[Candidate], budget: Budget
) -> tuple[Remedy, ...]:
    """The candidates that work."""
    remedies: list[Remedy] = []
    for candidate in possible:
        kind = candidate.change["kind"]
        if len(remedies) == MOST_REMEDIES:
            break
        if candidate.ticks > budget.left:
            budget.cut.append(kind)
            continue
        fires = Attempt(question.past, question.event, came, budget).trial(candidate.change).fired
        if fires is not None:
            text = text_of(question, candidate.change, fires)
            remedies.append(Remedy(kind, text, dict(candidate.change), fires))
    return tuple(remedies)


def _cut(budget: Budget) -> str:
    if not budget.cut:
        return ""
    kinds = ", ".join(WORDS[kind] for kind in dict.fromkeys(budget.cut))
    seconds = budget.ticks / budget.rate
    return (
        f"not tried to the end, for the stage would have to be played for more than {seconds:.1f} s: {kinds}"
    )


def _asked(stage: Stage, actor: int, event: str, tick: int) -> tuple[Question, bool]:
    """The question, with the verdict on the event, and whether the event came in the tick; if not, the
    verdict is the one it would have got.
    """
    if tick < 1:
        raise StageError(f"nothing can fire in tick {tick}: the first step makes tick 1")
    stage.check(tick)
    past = PastStates(stage, actor, tick)
    before = past.look_at(tick - 1)
    key, row = next((key, cast.row(actor)) for key, cast in before.casts.items() if cast.row(actor) >= 0)
    cast = Cast.of(stage.roles[key], before.casts[key])
    if event not in cast.role.machine.events:
        raise UnknownNameError("event", event, cast.role.machine.events)

    def verdicts(commands: list[Command]) -> list[Verdict]:
        _, effects = advance(stage.roles, before.copy(), commands, 1 / stage.rate, stage.seed)
        return [verdict for verdict in effects.verdicts if (verdict.actor, verdict.event) == (actor, event)]

    came = verdicts(stage.commands(tick))
    if event == END and not came:  # END cannot be sent
        state = cast.role.machine.states[cast.machine.state[row, 0]]
        why = "its motion has not come to the end, or nothing answers that"
        came = [Verdict(tick, actor, 0, END, "dropped", why, state, "")]
    answers = came or verdicts([*stage.commands(tick), Press(actor, event)])
    verdict = min(answers, key=lambda candidate: (candidate.verdict != "taken", candidate.layer))
    return Question(past, event, cast, row, verdict), bool(came)


def _summary(verdict: Verdict) -> str:
    return f"{verdict.verdict} in {verdict.from_state}" + (f": {verdict.reason}" if verdict.reason else "")
