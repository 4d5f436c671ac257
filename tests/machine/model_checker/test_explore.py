"""The search against a life: whatever happens to an actor is among what the search says can happen."""

import random

import pytest
from statwalk.machine.model_checker import search
from statwalk.machine.model_checker.lengths import EVEN, Lengths
from statwalk.machine.model_checker.program_in_ticks import program_in_ticks
from statwalk.machine.model_checker.search import beginning, searched
from statwalk.machine.model_checker.state_space import MOST_WAITING, NOT_BEGUN
from statwalk.machine.model_checker.work import Work, go_on
from statwalk.machine.runtime.state import BEGINNING
from ticking import RATE, Ticking

INPUTS = ("GO", "RUN", "HOP")
WHENS = (
    "",
    "",
    ", when: end",
    ", when: marker foot",
    ", when: marker hand",
    ", when: window 0.2..0.6",
    ", when: window 0.8..0.1",
)
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
    """A file over five motions, some of them loops, with markers, timings, conditions and weights."""
    chance = random.Random(seed)
    states = list(LENGTHS)
    places = [
        (state, event) for state in states for event in (*INPUTS, "foot", "END") if chance.random() < 0.55
    ]
    cells = "".join(
        f"  {state}/{event}: {random_cell(chance, state, states)}\n"
        for state, event in places
        if event != "END"
    )
    ends = "".join(
        f"  {state}/END: {{to: {chance.choice(states)}}}\n" for state, event in places if event == "END"
    )
    foot = chance.choice([0, 0.3, 1])
    marked = "".join(
        f"  {name}: {{motion: {name}, loop: {str(name.islower()).lower()}, markers: {{foot: {foot}, hand: "
        f"0.6}}}}\n"
        for name in states
    )
    header = "table: |\n  state | GO | RUN | HOP | foot | END\n" + "".join(
        f"  {name} | | | | |\n" for name in states
    )
    idle = chance.choice(["", "idle: GO\n"])
    parameters = "parameters: {p: {default: 0, min: 0, max: 3}}\n"
    return (
        f"character: c.glb\ninitial: A\ndefaults: {{buffer: 0.07}}\n{idle}{parameters}states:\n"
        f"{marked}{header}cells:\n{cells}{ends}"
    )


def node_of(actor):
    """The actor as the search sees it: state, time, begun, ended, no first one, what waits, and for how many
    ticks more.
    """
    memory = actor.memory
    time, passed, waiting = float(memory.time[0, 0]), float(memory.passed[0, 0]), int(memory.waiting[0, 0])
    assert abs(time * RATE - round(time * RATE)) < 1e-3, "the motions of this test begin at whole ticks"
    begun = NOT_BEGUN if passed == time else round((passed - BEGINNING) * RATE)
    columns = (memory.waiting_event, memory.waiting_for, memory.waiting_until)
    queued = zip(*(column[0, 0, :waiting].tolist() for column in columns), strict=True)
    places = [
        number for event, kind, until in queued for number in (event, kind, max(until - actor.tick - 1, 0))
    ]
    rest = [0] * (3 * (MOST_WAITING - waiting))
    return (
        int(memory.state[0, 0]),
        round(time * RATE),
        begun,
        int(memory.ended[0, 0]),
        0,
        waiting,
        *places,
        *rest,
    )


def search_of(machine, checkpoint=go_on):
    lasting = Lengths(tuple(LENGTHS.values()), (True,) * 5, (EVEN,) * 5)
    program = program_in_ticks(machine, lasting, is_patient=True)
    presses = [machine.columns[name] for name in INPUTS]
    return searched(program, beginning(program), (), presses, Work(10_000_000, checkpoint))


def following(actor):
    """For each node that the search knows the nodes that a tick may lead to; what waits in blank cells
    waits for its buffer.
    """
    whole = search_of(actor.machine)
    nodes = [tuple(row) for row in whole.space.node.tolist()]
    found = {node: set() for node in nodes}
    for start, end in zip(whole.start.tolist(), whole.end.tolist(), strict=True):
        found[nodes[start]].add(nodes[end])
    return found


@pytest.mark.parametrize("seed", range(40))
def test_what_happens_is_among_what_can_happen(seed):
    chance = random.Random(1000 + seed)
    actor = Ticking.of(random_machine(seed), LENGTHS)
    known = following(actor)
    for _ in range(150):
        before = node_of(actor)
        press = chance.choice(INPUTS) if not actor.memory.waiting[0, 0] and chance.random() < 0.2 else ""
        if chance.random() < 0.1:
            actor.set(p=round(chance.uniform(0, 3), 2))
        actor.step(*([press] if press else []))
        if press and actor.memory.waiting[0, 0] > 1:
            break  # the event waits beside one of a marker: the search leaves such lives out
        assert node_of(actor) in known[before]


def test_a_search_in_pieces_finds_the_same_and_lets_others_cancel_it(monkeypatch):
    """One node in each piece."""
    machine, looks = Ticking.of(random_machine(3), LENGTHS).machine, []
    whole = search_of(machine)
    monkeypatch.setattr(search, "PAUSE_WORK", 0)
    pieces = search_of(machine, lambda: looks.append(True))
    for name, array in whole.space._asdict().items():
        assert array.tolist() == getattr(pieces.space, name).tolist(), name
    assert len(looks) >= len(whole.space.node)
