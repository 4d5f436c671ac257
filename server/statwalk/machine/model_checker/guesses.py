"""Truths of conditions and draws that a tick has asked for, and those that are to be tried in their place."""

from __future__ import annotations

import numpy as np

from statwalk.machine.compile.alternatives import MIXED
from statwalk.machine.compile.program import NO_WEIGHT, Program
from statwalk.machine.conditions.condition_values import UNKNOWN
from statwalk.machine.model_checker.state_space import MOST_GUESSES, Guesses
from statwalk.machine.runtime.effects import ALTERNATIVE, EVENT, FROM, OF_VERDICTS, MachineEffects
from statwalk.machine.runtime.scratch import DRAWS
from statwalk.maths.reference import called

_OTHERWISE = 3
"""less a truth: the other one"""


@called
def guess_nothing(g: Guesses) -> None:
    """The stack holds one guess, of which nothing is known."""
    for condition in range(g.truths.shape[1]):
        g.truths[0, condition] = UNKNOWN
    for draw in range(g.draws.shape[1]):
        g.draws[0, draw] = np.nan


@called
def make_known(g: Guesses, guess: int, out: MachineEffects) -> None:
    """Tells a tick the truths and draws of a guess."""
    for condition in range(g.truths.shape[1]):
        out.work.conditions.truths[0, condition] = g.truths[guess, condition]
    for draw in range(g.draws.shape[1]):
        out.work.draws[0, draw] = g.draws[guess, draw]


@called
def guess_otherwise(p: Program, out: MachineEffects, g: Guesses, guess: int) -> int:
    """Puts in the place of a guess, after its tick, all guesses that part from what the tick has found out;
    the new height of the stack.

    What the tick asked for and the guess left open is split: the first condition otherwise; the first as it
    was and the second otherwise; and so on, then the draws in their order. So every run is met once. -1:
    there is no room.
    """
    top = guess
    for condition in range(g.truths.shape[1]):
        if is_asked(p, out, g, guess, condition):
            top += 1
            if top == MOST_GUESSES:
                return -1
            _copy(g, guess, top)
            for before in range(condition):
                g.truths[top, before] = out.work.conditions.truths[0, before]
            g.truths[top, condition] = _OTHERWISE - out.work.conditions.truths[0, condition]
    top = _draw_otherwise(p, out, g, guess, top)
    if top > guess:
        _copy(g, top, guess)
    return top


@called
def is_asked(p: Program, out: MachineEffects, g: Guesses, guess: int, condition: int) -> bool:
    """Whether the tick has asked for a condition that was left open, and that is not always the same."""
    is_new = g.truths[guess, condition] == UNKNOWN and out.work.conditions.truths[0, condition] != UNKNOWN
    return bool(is_new and p.asks[condition + 1] > p.asks[condition])


@called
def _copy(g: Guesses, source: int, target: int) -> None:
    for condition in range(g.truths.shape[1]):
        g.truths[target, condition] = g.truths[source, condition]
    for draw in range(g.draws.shape[1]):
        g.draws[target, draw] = g.draws[source, draw]


@called
def _draw_otherwise(p: Program, out: MachineEffects, g: Guesses, guess: int, top: int) -> int:
    draws = min(out.work.scratch[DRAWS], g.draws.shape[1])
    verdict, drawn = -1, -1
    for draw in range(draws):
        verdict, drawn = _next_drawn(p, out, verdict)
        if verdict < 0:
            return top
        if not np.isnan(g.draws[guess, draw]):
            continue
        cell = out.verdicts[verdict, FROM] * p.target.shape[1] + out.verdicts[verdict, EVENT]
        for other in range(p.alternatives[cell], p.alternatives[cell + 1]):
            if other != drawn and p.weight[other] > 0:
                top += 1
                if top == MOST_GUESSES:
                    return -1
                _copy(g, guess, top)
                for condition in range(g.truths.shape[1]):
                    g.truths[top, condition] = out.work.conditions.truths[0, condition]
                g.draws[top, draw] = _middle(p, cell, other)
        g.draws[guess, draw] = _middle(p, cell, drawn)
    return top


@called
def _next_drawn(p: Program, out: MachineEffects, verdict: int) -> tuple[int, int]:
    """The next verdict after `verdict` on what chance has decided, and the alternative; -1 none."""
    for row in range(verdict + 1, out.counts[OF_VERDICTS]):
        alternative = out.verdicts[row, ALTERNATIVE]
        if (
            alternative >= 0
            and p.weight[alternative] != NO_WEIGHT
            and p.target[out.verdicts[row, FROM], out.verdicts[row, EVENT]] == MIXED
        ):
            return row, alternative
    return -1, -1


@called
def _middle(p: Program, cell: int, alternative: int) -> float:
    """A draw in the middle of an alternative's share."""
    before, total = 0.0, 0.0
    for row in range(p.alternatives[cell], p.alternatives[cell + 1]):
        total += p.weight[row]
        if row < alternative:
            before += p.weight[row]
    return float((before + 0.5 * p.weight[alternative]) / total)
