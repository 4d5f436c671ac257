"""The program that the model checker steps: the base layer of a machine, in whole ticks."""

from __future__ import annotations

import math
from itertools import chain, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import MATCH
from statwalk.machine.compile.link import landings
from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.program import Program, program
from statwalk.machine.model_checker.lengths import EVEN, TICKS_PER_SECOND, Lengths
from statwalk.maths.arrays import Floats
from statwalk.maths.blend_tables import BlendRows, BlendTables
from statwalk.maths.phases import Warp


def program_in_ticks(machine: Machine, lengths: Lengths, is_patient: bool) -> Program:
    """Returns a program of one layer, for ticks of length 1: motions last `lengths` at speed 1, and senses
    raise nothing by themselves.

    Its durations are whole numbers, so that two nodes that mean the same are the same bits. A motion's time
    is the ticks that have gone, also of a blend, whose phases go faster here and slower there: what stands at
    a phase stands at its tick. So the time left after END has the pace of what it goes into.
    `is_patient`: events wait in blank cells for their buffers; else they do not wait there.
    """
    whole, states = machine.program, len(machine.rows(0))
    ticks, events = np.array(lengths.ticks, np.float64), len(machine.events)
    alternatives, pairs = whole.alternatives[: states * events + 1], len(whole.warps) and states
    buffers = [math.ceil(one * TICKS_PER_SECOND - 1e-4) if is_patient else 0 for one in whole.buffer.tolist()]
    base = {
        **{
            name: getattr(whole, name)[:states]
            for name in ("target", "when", "marker", "loop", "end_matters", "inside")
        },
        "alternatives": alternatives,
        **{name: getattr(whole, name)[: alternatives[-1]] for name in ALTERNATIVES},
        "enter": _entries(machine, lengths)[: alternatives[-1]],
        **_markers(machine, lengths),
        "warps": whole.warps[:pairs, :pairs],
        **_warps(machine, lengths, pairs),
        "received": whole.received[:, :1],
        "initials": whole.initials[:1],
        "duration": ticks,
        "speed": np.array(lengths.moves, np.float64),
        "speed_parameter": np.full(states, -1),
        "buffer": buffers,
        **dict.fromkeys(("sense_event", "sense_when", "sense_release"), np.zeros(0)),
        "blends": _no_blends(states),
    }
    opens, closes = _windows(machine, lengths)
    return program(**{**whole._asdict(), **base, "opens": opens, "closes": closes})


ALTERNATIVES = ("to", "restart", "blend", "curve", "enter", "action", "condition", "weight", "resume")


def _no_blends(states: int) -> BlendTables:
    rows = BlendRows()
    for _ in range(states):
        rows.add_none()
    return rows.tables()


def _entries(machine: Machine, lengths: Lengths) -> Floats:
    """(A,) the share of the new motion's ticks at which each alternative enters it; of several motions, the
    one with the most ticks left.
    """
    entries = machine.program.enter.copy()
    flat = chain.from_iterable(machine.alternatives[cell] for cell in sorted(machine.alternatives))
    for row, alternative in enumerate(flat):
        states = [state for state in landings(machine, alternative) if state < len(lengths.ticks)]
        if alternative.enter not in (0, MATCH) and states:
            entries[row] = min(lengths.share(state, alternative.enter) for state in states)
    return entries


def _markers(machine: Machine, lengths: Lengths) -> dict[str, NDArray[np.generic]]:
    whole, states = machine.program, len(lengths.ticks)
    first = whole.markers[: states + 1]
    seconds = [
        lengths.share(state, phase) * lengths.ticks[state]
        for state in range(states)
        for _, phase in machine.markers[state]
    ]
    names = {name: getattr(whole, name)[: first[-1]] for name in ("marker_name", "marker_event")}
    return {"markers": first, "marker_seconds": np.array(seconds, np.float64), **names}


def _windows(machine: Machine, lengths: Lengths) -> tuple[Floats, Floats]:
    shape = len(lengths.ticks), len(machine.events)
    opens, closes = np.full(shape, np.inf), np.full(shape, np.inf)
    for (state, event), timing in machine.timings.items():
        if timing.kind == "window" and state < len(lengths.ticks):
            opens[state, event], closes[state, event] = (
                lengths.share(state, phase) * lengths.ticks[state] for phase in (timing.first, timing.last)
            )
    return opens, closes


def _warps(machine: Machine, lengths: Lengths, states: int) -> dict[str, Any]:
    """The warps from ticks to ticks; from phases to phases where a motion does not go at one pace."""
    whole = machine.program
    warps = [
        Warp((origin[0], origin[1]), *whole.knot[first:past].T)
        for origin, (first, past) in zip(
            whole.warp_origin.tolist(), pairwise(whole.knots.tolist()), strict=True
        )
    ]
    for source, target in np.argwhere(whole.warps[:states, :states] >= 0).tolist():
        if (lengths.shares[source], lengths.shares[target]) != (EVEN, EVEN):
            row = whole.warps[source, target]
            warps[row] = _in_shares(warps[row], lengths, source, target)
    return {
        "warp_origin": np.array([warp.origin for warp in warps]).reshape(-1, 2),
        "knots": np.cumsum([0, *(len(warp.here) for warp in warps)]),
        "knot": np.concatenate([np.zeros((0, 2)), *(np.stack([warp.here, warp.there], 1) for warp in warps)]),
    }


def _in_shares(warp: Warp, lengths: Lengths, source: int, target: int) -> Warp:
    """The warp from shares of one motion's ticks to shares of another's."""
    back = Warp(warp.origin[::-1], warp.there, warp.here)
    old = [phase for phase, _ in lengths.shares[source]]
    new = back.lift([phase for phase, _ in lengths.shares[target]])
    phases = np.unique(np.concatenate([[0.0, 1.0], old, new % 1.0, (warp.origin[0] + warp.here) % 1.0]))
    there = warp.lift(phases)
    laps = np.floor(there)
    gone = np.array([lengths.share(source, phase) for phase in phases.tolist()])
    beyond = laps + [lengths.share(target, phase) for phase in (there - laps).tolist()]
    return Warp((0.0, float(beyond[0])), gone, beyond - beyond[0])
