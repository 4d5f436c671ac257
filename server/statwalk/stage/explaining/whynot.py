"""Why not: what kept an event from firing in a tick, and the single changes that would have made it fire: tried, cheapest first."""

from __future__ import annotations

from typing import Any, NamedTuple

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.authored.definition import END
from statwalk.stage.explaining.remedies import Candidate, Question, candidates, sense_of, sensed, text_of
from statwalk.stage.explaining.trying import tried
from statwalk.stage.fold import forward
from statwalk.stage.frame import Verdict
from statwalk.stage.past.log import LogEntry
from statwalk.stage.stage import Stage

MOST_REMEDIES = 8


class Remedy(NamedTuple):
    """One change that makes the event fire. `change` is what `trying.tried` takes; `fires`: the tick in which it did there."""

    kind: str
    text: str
    change: dict[str, Any]
    fires: int


class WhyNot(NamedTuple):
    """What became of the event, and what would have made it fire; `remedies` are empty where it has fired, or where nothing helps."""

    fired: bool
    reason: str
    remedies: tuple[Remedy, ...]


def whynot(stage: Stage, actor: int, event: str, tick: int) -> WhyNot:
    """Why `event` did not fire for an actor in `tick` (from 1 on), sent or not; every remedy has been seen to work in a fork.

    Raises StageError where that tick is not there, UnknownNameError where the actor is not, or its machine knows no such event.
    """
    question, sent = _asked(stage, actor, event, tick)
    if sent and question.verdict.verdict == "taken":
        return WhyNot(True, _said(question.verdict), ())
    if question.verdict.verdict == "taken":
        found = [Candidate(0.0, {"kind": "send", "event": event, "tick": tick}), *sensed(question)]
        reason = sense_of(question) or "nobody sent it in this tick"
    else:
        found = sorted(candidates(question), key=lambda one: one.cost)
        reason = _said(question.verdict) if sent else f"nobody sent it in this tick; and if somebody had: {_said(question.verdict)}"
    remedies: list[Remedy] = []
    for one in found:
        fires = tried(stage, actor, event, tick, one.change).fired if len(remedies) < MOST_REMEDIES else None
        if fires is not None:
            remedies.append(Remedy(one.change["kind"], text_of(question, one.change, fires), dict(one.change), fires))
    return WhyNot(False, reason, tuple(remedies))


def _asked(stage: Stage, actor: int, event: str, tick: int) -> tuple[Question, bool]:
    """The question, with the verdict on the event, and whether it came in that tick; else the verdict is the one it would have got."""
    if tick < 1:
        raise StageError(f"nothing can fire in tick {tick}: the first step makes tick 1")
    stage.state_at(tick)
    before, entries = stage.state_at(tick - 1), stage.entries(tick)
    found = before.find(actor)
    if found is None:
        raise UnknownNameError("actor", str(actor), [str(one) for cast in before.casts for one in cast.ids])
    cast, row = found
    if event not in cast.role.machine.events:
        raise UnknownNameError("event", event, cast.role.machine.events)

    def verdicts(given: list[LogEntry]) -> list[Verdict]:
        done = forward(before, given, 1 / stage.rate, stage.seed)
        return [one for one in done.verdicts if (one.actor, one.event) == (actor, event)]

    came = verdicts(entries)
    if event == END and not came:  # nobody can send it
        here = cast.role.machine.states[cast.machine.state[row, 0]]
        came = [Verdict(tick, actor, 0, END, "dropped", "its motion has not come to the end, or nothing answers that", here, "")]
    given = came or verdicts([*entries, LogEntry(tick, "press", actor, event)])
    verdict = min(given, key=lambda one: (one.verdict != "taken", one.layer))
    return Question(stage, actor, event, tick, cast, row, verdict), bool(came)


def _said(verdict: Verdict) -> str:
    """A verdict in a line."""
    return f"{verdict.verdict} in {verdict.from_state}" + (f": {verdict.reason}" if verdict.reason else "")
