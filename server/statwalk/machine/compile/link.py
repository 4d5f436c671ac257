"""Builds the program of a compiled machine, and the text for its numbers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from statwalk.machine.compile.alternatives import BLANK, MATCH, OFF, Outcome
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.program import (
    NO_CONDITION,
    NO_WEIGHT,
    Program,
    ProgramText,
    program,
)
from statwalk.machine.conditions.condition_code import condition_arrays
from statwalk.maths.formula.postfix import Formula as Condition
from statwalk.maths.phases import Warp, warp

REACHED = 6.6383521
"""ωt at which (1 + ωt) e^-ωt is 0.01: after `smooth` seconds a hundredth of the difference is left"""


def linked(machine: Machine) -> Machine:
    """Returns the machine with its program and the text for the program's numbers."""
    object.__setattr__(machine, "program", _program_of(machine))
    object.__setattr__(machine, "text", _text_of(machine))
    return machine


def _program_of(machine: Machine) -> Program:
    conditions = _conditions(machine)
    return program(
        target=machine.target,
        when=machine.when,
        **_moments(machine),
        **_alternatives(machine, conditions),
        buffer=machine.buffer,
        received=machine.received,
        duration=machine.duration,
        loop=machine.loop,
        speed=machine.speed,
        speed_parameter=machine.speed_parameter,
        end_matters=machine.end_matters,
        inside=machine.inside,
        **_markers(machine),
        **_warps(machine),
        **condition_arrays(conditions.values(), machine.variables, len(machine.parameters)),
        **_parameters(machine),
        **_senses(machine, conditions),
        initials=machine.initials,
        idle=[machine.idle],
    )


def _text_of(machine: Machine) -> ProgramText:
    outcomes = [outcome for _, outcomes in _by_cell(machine) for outcome in outcomes]
    return ProgramText(
        states=machine.states,
        events=machine.events,
        variables=machine.variables,
        actions=tuple((action.name, action.arguments) for action in machine.actions),
        written=tuple(outcome.to for outcome in outcomes),
        conditions=tuple(outcome.said for outcome in outcomes),
        senses=tuple(sense.said for sense in machine.senses),
        moments={place: str(moment) for place, moment in machine.moments.items()},
        cells=dict(machine.sources),
    )


def _by_cell(machine: Machine) -> Iterable[tuple[tuple[int, int], tuple[Outcome, ...]]]:
    """All cells in the order of states and events, each with its outcomes; a cell may have none."""
    states, events = machine.target.shape
    return (
        ((state, event), machine.outcomes.get((state, event), ()))
        for state in range(states)
        for event in range(events)
    )


def _conditions(machine: Machine) -> dict[int, Condition]:
    """All conditions, each once, in the order of their rows; keyed by id, as conditions live as long as the
    machine.
    """
    of_outcomes = (outcome.condition for outcomes in machine.outcomes.values() for outcome in outcomes)
    of_senses = (condition for sense in machine.senses for condition in (sense.when, sense.release))
    return {id(condition): condition for condition in (*of_outcomes, *of_senses) if condition is not None}


def _rows(conditions: dict[int, Condition], asked: Iterable[Condition | None]) -> list[int]:
    """The row of each asked condition, NO_CONDITION for None."""
    rows = {key: row for row, key in enumerate(conditions)}
    return [NO_CONDITION if condition is None else rows[id(condition)] for condition in asked]


def _firsts(counts: Iterable[int]) -> list[int]:
    """The first row of each of several lists laid one after the other, then the end of the last list."""
    return [0, *np.cumsum(list(counts)).astype(int).tolist()]


def _marker_names(machine: Machine) -> dict[str, int]:
    """A number for each marker name, of a motion or in a cell."""
    names = [name for markers in machine.markers for name, _ in markers]
    names += [moment.marker for moment in machine.moments.values() if moment.kind == "marker"]
    return {name: number for number, name in enumerate(dict.fromkeys(names))}


def _moments(machine: Machine) -> dict[str, Any]:
    marker, numbers = np.full(machine.target.shape, -1), _marker_names(machine)
    for place, moment in machine.moments.items():
        if moment.kind == "marker":
            marker[place] = numbers[moment.marker]
    opens, closes = machine.windows
    return {"marker": marker, "opens": opens, "closes": closes}


def _alternatives(machine: Machine, conditions: dict[int, Condition]) -> dict[str, Any]:
    cells = [outcomes for _, outcomes in _by_cell(machine)]
    flat = [outcome for outcomes in cells for outcome in outcomes]
    return {
        "alternatives": _firsts(map(len, cells)),
        "to": [outcome.target for outcome in flat],
        "restart": [outcome.restart for outcome in flat],
        "blend": [outcome.blend for outcome in flat],
        "curve": [outcome.curve for outcome in flat],
        "enter": [outcome.enter for outcome in flat],
        "action": [outcome.action for outcome in flat],
        "condition": _rows(conditions, (outcome.condition for outcome in flat)),
        "weight": [NO_WEIGHT if outcome.weight is None else outcome.weight for outcome in flat],
        "resume": [outcome.resume for outcome in flat],
    }


def _markers(machine: Machine) -> dict[str, Any]:
    numbers = _marker_names(machine)
    return {
        "markers": _firsts(map(len, machine.markers)),
        "marker_seconds": [
            phase * machine.duration[row]
            for row, markers in enumerate(machine.markers)
            for _, phase in markers
        ],
        "marker_name": [numbers[name] for markers in machine.markers for name, _ in markers],
        "marker_event": [
            _marker_event(machine, row, name)
            for row, markers in enumerate(machine.markers)
            for name, _ in markers
        ],
    }


def _marker_event(machine: Machine, state: int, name: str) -> int:
    """The column of the event that a marker raises; -1 if no event has its name, or the state's cell is blank
    or off.
    """
    column = machine.columns.get(name, -1)
    return -1 if column < 0 or machine.target[state, column] in (BLANK, OFF) else column


def _warps(machine: Machine) -> dict[str, Any]:
    """The correspondence of phases for each pair of states that a cell with MATCH may connect."""
    warps: dict[tuple[int, int], Warp] = {}
    for (source, _), outcomes in machine.outcomes.items():
        matched = (outcome for outcome in outcomes if outcome.enter == MATCH)
        for target in (state for outcome in matched for state in _landings(machine, outcome)):
            loop = bool(machine.loop[source] and machine.loop[target])
            warps[source, target] = warp(machine.markers[source], machine.markers[target], loop)
    size = len(machine.states) if warps else 0
    rows = np.full((size, size), -1)
    for row, pair in enumerate(warps):
        rows[pair] = row
    knots = [np.stack([phases.here, phases.there], 1) for phases in warps.values()]
    return {
        "warps": rows,
        "warp_loop": [machine.loop[source] and machine.loop[target] for source, target in warps],
        "warp_origin": np.array([phases.origin for phases in warps.values()]).reshape(-1, 2),
        "knots": _firsts(map(len, knots)),
        "knot": np.concatenate(knots) if knots else np.zeros((0, 2)),
    }


def _landings(machine: Machine, outcome: Outcome) -> list[int]:
    """The states that an outcome may lead to: several if it resumes a composite state."""
    inside = machine.inside[:, outcome.resume].nonzero()[0].tolist() if outcome.resume >= 0 else []
    return [state for state in (outcome.target, *inside) if state >= 0]


def _parameters(machine: Machine) -> dict[str, Any]:
    parameters = machine.parameters
    return {
        "default": [parameter.default for parameter in parameters],
        "minimum": [parameter.minimum for parameter in parameters],
        "maximum": [parameter.maximum for parameter in parameters],
        "omega": [REACHED / parameter.smooth if parameter.smooth > 0 else 0.0 for parameter in parameters],
    }


def _senses(machine: Machine, conditions: dict[int, Condition]) -> dict[str, Any]:
    senses = machine.senses
    return {
        "sense_event": [sense.event for sense in senses],
        "sense_when": _rows(conditions, (sense.when for sense in senses)),
        "sense_release": _rows(conditions, (sense.release for sense in senses)),
    }
