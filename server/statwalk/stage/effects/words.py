"""Sentences for the codes of verdicts, for example "the cell is blank; it waits for 0.3 s".

A sentence is made when it is read.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from statwalk.machine.compile.alternatives import MIXED
from statwalk.machine.compile.program import NO_WEIGHT, Program, ProgramText
from statwalk.machine.runtime import reasons
from statwalk.machine.runtime.effects import MOST_CHANGES
from statwalk.machine.runtime.result import VerdictCodes
from statwalk.machine.runtime.state import MOST_WAITING
from statwalk.stage.state import pending_events
from statwalk.stage.state.pending_events import MOST_RAISED, Notice, PendingEvent

BUFFERED = {
    reasons.BLANK_CELL: "the cell is blank",
    reasons.NOTHING_TRUE: "nothing in the cell is true",
    reasons.BLANK_AND_OVER: "the cell is blank",
    reasons.NOTHING_TRUE_AND_OVER: "nothing in the cell is true",
}
"""why an event waits for its buffer, or waited for it"""
PLAIN = {
    reasons.AT_ONCE: "",
    reasons.AFTER_THE_END: "the motion has ended",
    reasons.AT_THE_END: "at the end of the motion",
    reasons.IDLE: "nothing else happened at the end of the motion",
    reasons.CHANGES_ARE_MADE: f"{MOST_CHANGES} changes were made in this tick",
    reasons.TOO_MANY_WAIT: f"more than {MOST_WAITING} were waiting, and it was the oldest",
    reasons.RELEASED: "it was released",
    reasons.HELD_ALREADY: "it is held already",
    reasons.ONLY_MOTIONS_END: "only a motion raises END",
    reasons.OFF_CELL: "the cell is -",
}
"""the reasons whose sentence is the same for every cell"""
NOTICES = {
    pending_events.NO_OTHER: "there is no other",
    pending_events.NOBODY_KNOWS: "no other actor knows {event}",
    pending_events.NOBODY_IS_CALLED: "no actor is called {target}",
    pending_events.TOO_MANY_RAISED: f"more than {MOST_RAISED} events were raised on it in one tick",
    pending_events.NO_SUCH_EVENT: "{role} has no event {event}",
    pending_events.NO_SUCH_STATE: "{role} has no state {event}",
    pending_events.STATE_IS_GONE: "the edit has no state {from_state}",
    pending_events.STATE_IS_RENAMED: "the edit calls {from_state} {to_state}",
    pending_events.EVENT_IS_GONE: "the edit has no such event",
}
"""the reasons of notices, with fields of the notice and `role`, the name of the actor's role"""


class Line(NamedTuple):
    """One verdict with named columns, in the order of `MachineEffects.verdicts`."""

    actor: int
    layer: int
    event: int
    verdict: int
    reason: int
    from_state: int
    to_state: int
    """-1: the state stayed"""
    alternative: int
    other: int
    note: int
    """the sense that raised the event, -1 none"""
    arrived: int
    past_values: int


def lines(verdicts: VerdictCodes) -> Iterator[Line]:
    """Returns the verdicts one by one."""
    return (Line(*row) for row in verdicts.rows.tolist())


def values_of(text: ProgramText, verdicts: VerdictCodes, row: int) -> tuple[tuple[str, float], ...]:
    """Returns name and value of each variable that the conditions of a verdict have read."""
    first = int(verdicts.rows[row - 1, -1]) if row else 0
    past = int(verdicts.rows[row, -1])
    return tuple(
        (text.variables[variable], value)
        for variable, value in zip(
            verdicts.variable[first:past].tolist(), verdicts.value[first:past].tolist(), strict=True
        )
    )


def sentence(program: Program, text: ProgramText, line: Line) -> str:
    """Returns the reason of a verdict."""
    parts = [f"sensed: {text.senses[line.note]}" if line.note >= 0 else "", _reason(program, text, line)]
    if reasons.VERDICTS[line.verdict] == "taken":
        parts += [_because(program, text, line), "arrived, the journey is over" if line.arrived else ""]
        if not any(parts[1:]) and line.to_state < 0:
            parts.append("stays")
    return "; ".join(filter(None, parts))


def notice_sentence(notice: Notice, role: str) -> str:
    """Returns the reason of a notice; `role` is the name of the actor's role."""
    return NOTICES[notice.reason].format(role=role, **notice._asdict())


def touch_sentence(event: PendingEvent) -> str:
    """Returns place and time of a touch as a sentence."""
    place = ", ".join(f"{part:.2f}" for part in event.point or ())
    return f"touched at {place} m, {event.time:.2f} into the tick"


def _reason(program: Program, text: ProgramText, line: Line) -> str:
    code, place = line.reason, (line.from_state, line.event)
    if code in PLAIN:
        return PLAIN[code]
    if code in BUFFERED:
        return _buffered(program, line)
    if code == reasons.AT_ITS_MOMENT:
        return f"{text.timings[place]} has come"
    if code == reasons.FOR_ITS_MOMENT:
        return f"the cell says: {_timing(text, place)}"
    if code == reasons.NO_STATE:
        return f"{text.written[line.alternative]} is no state"
    what = text.timings.get(place, "end")
    return f"{text.states[line.from_state]} was left before its {what}"


def _timing(text: ProgramText, place: tuple[int, int]) -> str:
    timing = text.timings.get(place, "end")
    return timing if timing.startswith("window") else f"at {timing}"


def _buffered(program: Program, line: Line) -> str:
    why, seconds = BUFFERED[line.reason], f"{program.buffer[line.event]:g} s"
    if reasons.VERDICTS[line.verdict] == "waits":
        return f"{why}; it waits for {seconds}"
    return (
        f"{why}, and {seconds} are over"
        if line.reason in (reasons.BLANK_AND_OVER, reasons.NOTHING_TRUE_AND_OVER)
        else why
    )


def _because(program: Program, text: ProgramText, line: Line) -> str:
    """Returns why this alternative of the cell was chosen."""
    row, cell = line.alternative, line.from_state * len(text.events) + line.event
    if program.target[line.from_state, line.event] != MIXED:
        return ""
    first, past = program.alternatives[cell : cell + 2].tolist()
    if program.weight[row] != NO_WEIGHT:
        return f"drawn, {program.weight[row]:g} of {sum(program.weight[first:past].tolist()):g}"
    if text.conditions[row]:
        return f"since {text.conditions[row]}"
    return "since nothing before it is true" if any(text.conditions[first:row]) else ""
