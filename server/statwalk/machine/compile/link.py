"""Builds the program of a compiled machine, and the text for its numbers."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from statwalk.machine.compile.alternatives import BLANK, MATCH, OFF, Alternative
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.program import (
    NO_CONDITION,
    NO_WEIGHT,
    Program,
    ProgramText,
    program,
)
from statwalk.machine.conditions.condition_code import condition_arrays
from statwalk.machine.conditions.variables import ENTRY
from statwalk.maths.blend_tables import BlendRows, BlendTables
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
        **_timings(machine),
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
        entry_state=[state for state, _ in machine.entry_values],
        entry_kind=[ENTRY[name] for _, name in machine.entry_values],
        initials=machine.initials,
        idle=[machine.idle],
        blends=_blends(machine),
    )


def _text_of(machine: Machine) -> ProgramText:
    alternatives = [alternative for _, alternatives in _by_cell(machine) for alternative in alternatives]
    return ProgramText(
        states=machine.states,
        events=machine.events,
        variables=machine.variables,
        actions=tuple((action.name, action.arguments) for action in machine.actions),
        written=tuple(alternative.to for alternative in alternatives),
        conditions=tuple(
            alternative.condition.text if alternative.condition else "" for alternative in alternatives
        ),
        senses=tuple(sense.when.text for sense in machine.senses),
        timings={place: str(timing) for place, timing in machine.timings.items()},
        cells=dict(machine.sources),
    )


def _by_cell(machine: Machine) -> Iterable[tuple[tuple[int, int], tuple[Alternative, ...]]]:
    """All cells in the order of states and events, each with its alternatives; a cell may have none."""
    states, events = machine.target.shape
    return (
        ((state, event), machine.alternatives.get((state, event), ()))
        for state in range(states)
        for event in range(events)
    )


def _conditions(machine: Machine) -> dict[int, Condition]:
    """All conditions, each once, in the order of their rows; keyed by id, as conditions live as long as the
    machine.
    """
    of_alternatives = (
        alternative.condition
        for alternatives in machine.alternatives.values()
        for alternative in alternatives
    )
    of_senses = (condition for sense in machine.senses for condition in (sense.when, sense.release))
    return {id(condition): condition for condition in (*of_alternatives, *of_senses) if condition is not None}


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
    names += [timing.marker for timing in machine.timings.values() if timing.kind == "marker"]
    return {name: number for number, name in enumerate(dict.fromkeys(names))}


def _timings(machine: Machine) -> dict[str, Any]:
    marker, numbers = np.full(machine.target.shape, -1), _marker_names(machine)
    for place, timing in machine.timings.items():
        if timing.kind == "marker":
            marker[place] = numbers[timing.marker]
    opens, closes = machine.windows
    return {"marker": marker, "opens": opens, "closes": closes}


def _alternatives(machine: Machine, conditions: dict[int, Condition]) -> dict[str, Any]:
    cells = [alternatives for _, alternatives in _by_cell(machine)]
    flat = [alternative for alternatives in cells for alternative in alternatives]
    return {
        "alternatives": _firsts(map(len, cells)),
        "to": [alternative.target for alternative in flat],
        "restart": [alternative.restart for alternative in flat],
        "blend": [alternative.blend for alternative in flat],
        "curve": [alternative.curve for alternative in flat],
        "enter": [alternative.enter for alternative in flat],
        "action": [alternative.action for alternative in flat],
        "condition": _rows(conditions, (alternative.condition for alternative in flat)),
        "weight": [NO_WEIGHT if alternative.weight is None else alternative.weight for alternative in flat],
        "resume": [alternative.resume for alternative in flat],
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
    for (source, _), alternatives in machine.alternatives.items():
        matched = (alternative for alternative in alternatives if alternative.enter == MATCH)
        for target in (state for alternative in matched for state in landings(machine, alternative)):
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


def landings(machine: Machine, alternative: Alternative) -> list[int]:
    """Returns the states that an alternative may lead to: several if it resumes a composite state."""
    inside = machine.inside[:, alternative.resume].nonzero()[0].tolist() if alternative.resume >= 0 else []
    return [state for state in (alternative.target, *inside) if state >= 0]


def _parameters(machine: Machine) -> dict[str, Any]:
    parameters = machine.parameters
    return {
        "default": [parameter.default for parameter in parameters],
        "minimum": [parameter.minimum for parameter in parameters],
        "maximum": [parameter.maximum for parameter in parameters],
        "omega": [REACHED / parameter.smooth if parameter.smooth > 0 else 0.0 for parameter in parameters],
    }


def _blends(machine: Machine) -> BlendTables:
    """The clips of each state that plays a blend; the other states have none."""
    rows = BlendRows()
    for state, (blend, clips) in enumerate(zip(machine.blends, machine.blended_clips, strict=True)):
        if blend is None:
            rows.add_none()
            continue
        places = np.array(list(blend.clips.values()), np.float64)
        over = [machine.axis(state, name) for name in blend.over]
        rows.add(clips, places, over, bool(machine.loop[state]))
    return rows.tables()


def _senses(machine: Machine, conditions: dict[int, Condition]) -> dict[str, Any]:
    senses = machine.senses
    return {
        "sense_event": [sense.event for sense in senses],
        "sense_when": _rows(conditions, (sense.when for sense in senses)),
        "sense_release": _rows(conditions, (sense.release for sense in senses)),
    }
