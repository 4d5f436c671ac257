"""The program that the model checker steps: the base layer of a machine, in whole ticks."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.program import Program, program
from statwalk.machine.model_checker.lengths import TICKS_PER_SECOND, Lengths


def program_in_ticks(machine: Machine, lengths: Lengths, is_patient: bool) -> Program:
    """Returns a program of one layer, for ticks of length 1: motions last `lengths` at speed 1, and senses
    raise nothing by themselves.

    All its times are whole numbers, so that two nodes that mean the same are the same bits.
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
        **_markers(machine, ticks),
        "warps": whole.warps[:pairs, :pairs],
        "received": whole.received[:, :1],
        "initials": whole.initials[:1],
        "duration": ticks,
        "speed": np.array(lengths.moves, np.float64),
        "speed_parameter": np.full(states, -1),
        "buffer": buffers,
        **dict.fromkeys(("sense_event", "sense_when", "sense_release"), np.zeros(0)),
    }
    opens, closes = _windows(machine, ticks)
    return program(**{**whole._asdict(), **base, "opens": opens, "closes": closes})


ALTERNATIVES = ("to", "restart", "blend", "curve", "enter", "action", "condition", "weight", "resume")


def _markers(machine: Machine, ticks: NDArray[np.float64]) -> dict[str, NDArray[np.generic]]:
    whole, states = machine.program, len(ticks)
    first = whole.markers[: states + 1]
    seconds = [phase * ticks[state] for state in range(states) for _, phase in machine.markers[state]]
    names = {name: getattr(whole, name)[: first[-1]] for name in ("marker_name", "marker_event")}
    return {"markers": first, "marker_seconds": np.array(seconds, np.float64), **names}


def _windows(machine: Machine, ticks: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    shape = len(ticks), len(machine.events)
    opens, closes = np.full(shape, np.inf), np.full(shape, np.inf)
    for (state, event), timing in machine.timings.items():
        if timing.kind == "window" and state < len(ticks):
            opens[state, event], closes[state, event] = (
                timing.first * ticks[state],
                timing.last * ticks[state],
            )
    return opens, closes
