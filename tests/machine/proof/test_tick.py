"""The search's tick against the one that runs: whatever happens to an actor is among what the search says can happen."""

import random

import numpy as np
import pytest
from statwalk.machine.proof.lengths import Lengths
from statwalk.machine.proof.moments import EARLIER, FOR_END, FOR_MOMENT, NOBODY, Node
from statwalk.machine.proof.tick import Ticks
from statwalk.machine.ticking.state import BEGINNING, FOREVER, MOMENT
from ticking import RATE, Ticking

INPUTS = ("GO", "RUN", "HOP")
WHENS = ("", "", ", when: end", ", when: marker foot", ", when: marker hand", ", when: window 0.2..0.6", ", when: window 0.8..0.1")
LENGTHS = {"A": 18, "b": 18, "C": 2, "d": 24, "E": 24}
"""ticks"""


def random_cell(chance, state, states):
    """A cell's text."""
    to, other = chance.choices(states, k=2)
    when = chance.choice(WHENS)
    match chance.randrange(8):
        case 0:
            return f"{{to: [{{if: p > 1, to: {to}}}, {{if: p > 2, to: {other}}}]{when}}}"
        case 1:
            return f"{{to: [{{if: p > 1, to: {to}}}, {{to: {other}}}]{when}}}"
        case 2 if other != to:
            return f"{{to: {{{to}: 3, {other}: 1}}{when}}}"
        case 3:
            enter = "match" if LENGTHS[state] == LENGTHS[to] else "0.5"
            return f"{{to: {to}{chance.choice(['', '!'])}, enter: {enter}{when}}}"
        case 4:
            return f"{{to: {to}, off: true}}"
    return f"{{to: {to}{chance.choice(['', '', '!'])}{when}}}"


def random_machine(seed):
    """A file over five motions, some of them loops, with markers, moments, conditions and weights."""
    chance = random.Random(seed)
    states = list(LENGTHS)
    places = [(state, event) for state in states for event in (*INPUTS, "foot", "END") if chance.random() < 0.55]
    cells = "".join(f"  {state}/{event}: {random_cell(chance, state, states)}\n" for state, event in places if event != "END")
    ends = "".join(f"  {state}/END: {{to: {chance.choice(states)}}}\n" for state, event in places if event == "END")
    foot = chance.choice([0, 0.3, 1])
    marked = "".join(
        f"  {name}: {{motion: {name}, loop: {str(name.islower()).lower()}, markers: {{foot: {foot}, hand: 0.6}}}}\n" for name in states
    )
    header = "table: |\n  state | GO | RUN | HOP | foot | END\n" + "".join(f"  {name} | | | | |\n" for name in states)
    idle = chance.choice(["", "idle: GO\n"])
    parameters = "parameters: {p: {default: 0, min: 0, max: 3}}\n"
    return f"character: c.glb\ninitial: A\ndefaults: {{buffer: 0.07}}\n{idle}{parameters}states:\n{marked}{header}cells:\n{cells}{ends}"


def node_of(actor):
    """The actor as the search sees it."""
    memory = actor.memory
    queued = zip(memory.waiting_event[0, 0].tolist(), memory.waiting_until[0, 0].tolist(), strict=True)
    queue = tuple((event, {FOREVER: FOR_END, MOMENT: FOR_MOMENT}.get(until, until - actor.tick)) for event, until in queued if event >= 0)
    time = memory.time[0, 0] * RATE
    assert abs(time - round(time)) < 1e-3, "the motions of this test begin at whole ticks"
    began = round((float(memory.passed[0, 0]) - BEGINNING) * RATE)
    lap = LENGTHS[actor.state] if actor.state.islower() else began + 1
    begun = EARLIER if memory.passed[0, 0] == memory.time[0, 0] else began % lap
    return Node(int(memory.state[0, 0]), round(time), begun, int(memory.ended[0, 0]), queue)


@pytest.mark.parametrize("seed", range(40))
def test_what_happens_is_among_what_can_happen(seed):
    chance = random.Random(1000 + seed)
    actor = Ticking.of(random_machine(seed), LENGTHS)
    ticks = Ticks(actor.machine, Lengths(tuple(LENGTHS.values()), (True,) * 5), patient=True)
    for _ in range(150):
        before = node_of(actor)
        press = chance.choice(INPUTS) if not before.queue and chance.random() < 0.2 else ""
        if chance.random() < 0.1:
            actor.set(p=float(np.round(chance.uniform(0, 3), 2)))
        actor.step(*([press] if press else []))
        assert node_of(actor) in [one.node for one in ticks.after(before, actor.machine.columns[press] if press else NOBODY)]
